-- Step from version 1 to version 2 of the project file: what a diagnosis proposes. This text never changes again.

CREATE TABLE proposal (
  number           INTEGER PRIMARY KEY AUTOINCREMENT,  -- shown as P1, P2, ...
  state            TEXT NOT NULL CHECK (state IN ('open', 'accepted', 'dismissed')),
  row_key          TEXT NOT NULL,       -- of the relevance table; empty: an acceptance test is proposed
  cause            TEXT NOT NULL,
  experiment       TEXT NOT NULL,
  model            TEXT NOT NULL,
  report           TEXT NOT NULL,       -- file
  report_sha256    TEXT NOT NULL,
  evidence         TEXT NOT NULL,       -- SHA-256 of the report's content without the time that it took
  occurrence       INTEGER CHECK (occurrence BETWEEN 1 AND 10),
  before           INTEGER,             -- the row's occurrence when this was proposed
  before_rationale TEXT NOT NULL,
  before_expert    TEXT NOT NULL,
  rationale        TEXT NOT NULL,
  requirements     TEXT NOT NULL,       -- list of uids: what the test would verify
  proposed_by      TEXT NOT NULL,
  proposed_at      TEXT NOT NULL,
  decided_by       TEXT NOT NULL,
  decided_at       TEXT NOT NULL,
  reason           TEXT NOT NULL,
  UNIQUE (evidence, row_key)            -- the same evidence proposes once
) STRICT;

CREATE TABLE proposal_field (           -- the proposed acceptance test, by the names of its columns
  proposal INTEGER NOT NULL REFERENCES proposal (number) ON DELETE CASCADE,
  name     TEXT NOT NULL,
  value    TEXT NOT NULL,
  PRIMARY KEY (proposal, name)
) STRICT, WITHOUT ROWID;
