-- The project file, version 1. Later versions are steps of their own (migrations.h); this text never changes again.
-- Every thing that can be linked is one row of `item`; what is special to its kind stands in a table of that kind.

CREATE TABLE project (
  only_row    INTEGER PRIMARY KEY CHECK (only_row = 1),
  uid         TEXT NOT NULL,
  next_number INTEGER NOT NULL          -- of the next uid
) STRICT;

CREATE TABLE item (
  uid       TEXT PRIMARY KEY,
  kind      TEXT NOT NULL CHECK (kind IN ('CEPRA row', 'requirement', 'acceptance test',
                                          'experiment data requirement', 'reference data requirement')),
  id        TEXT NOT NULL UNIQUE,       -- shown
  title     TEXT NOT NULL,
  text      TEXT NOT NULL,
  rationale TEXT NOT NULL,
  author    TEXT NOT NULL,
  status    TEXT NOT NULL CHECK (status IN ('under review', 'accepted', 'rejected'))
) STRICT;

CREATE TABLE requirement (
  uid     TEXT PRIMARY KEY REFERENCES item (uid) ON DELETE CASCADE,
  level   TEXT NOT NULL CHECK (level IN ('general', 'object-model', 'detection-model')),
  effects TEXT NOT NULL                 -- list: see joinList
) STRICT;

CREATE TABLE acceptance_test (
  uid        TEXT PRIMARY KEY REFERENCES item (uid) ON DELETE CASCADE,
  experiment TEXT NOT NULL,
  model      TEXT NOT NULL,
  measurand  TEXT NOT NULL,
  gate       TEXT NOT NULL,
  metric     TEXT NOT NULL,
  expression TEXT NOT NULL,
  samples    TEXT NOT NULL,             -- list
  frames     TEXT NOT NULL,             -- empty or a number
  options    TEXT NOT NULL              -- list of name=value
) STRICT;

CREATE TABLE experiment_data (
  uid         TEXT PRIMARY KEY REFERENCES item (uid) ON DELETE CASCADE,
  experiment  TEXT NOT NULL,
  device      TEXT NOT NULL,
  conditions  TEXT NOT NULL,
  repetitions TEXT NOT NULL
) STRICT;

CREATE TABLE reference_data (
  uid         TEXT PRIMARY KEY REFERENCES item (uid) ON DELETE CASCADE,
  quantity    TEXT NOT NULL,
  device      TEXT NOT NULL,
  uncertainty TEXT NOT NULL
) STRICT;

CREATE TABLE link (
  origin   TEXT NOT NULL REFERENCES item (uid) ON DELETE CASCADE,
  follower TEXT NOT NULL REFERENCES item (uid) ON DELETE CASCADE,
  suspect  INTEGER NOT NULL DEFAULT 0 CHECK (suspect IN (0, 1)),
  PRIMARY KEY (origin, follower),
  CHECK (origin <> follower)
) STRICT, WITHOUT ROWID;
CREATE INDEX link_back ON link (follower);

CREATE TABLE change (                   -- outlives the item
  number  INTEGER PRIMARY KEY AUTOINCREMENT,
  uid     TEXT NOT NULL,
  id      TEXT NOT NULL,
  who     TEXT NOT NULL,
  changed TEXT NOT NULL,                -- when
  what    TEXT NOT NULL
) STRICT;
CREATE INDEX change_of ON change (uid);

-- The imported graph.

CREATE TABLE graph (
  only_row INTEGER PRIMARY KEY CHECK (only_row = 1),
  tree     TEXT NOT NULL,
  source   TEXT NOT NULL,
  sha256   TEXT NOT NULL,
  who      TEXT NOT NULL,
  imported TEXT NOT NULL                -- when
) STRICT;

CREATE TABLE graph_node (
  position         INTEGER PRIMARY KEY, -- in the graph; edges name it
  id               TEXT NOT NULL UNIQUE,
  title            TEXT NOT NULL,
  kind             TEXT NOT NULL,
  block            TEXT NOT NULL,
  description      TEXT NOT NULL,
  references_text  TEXT NOT NULL,
  placement_parent TEXT NOT NULL,
  file             TEXT NOT NULL,
  line             INTEGER NOT NULL,
  phenomenon       INTEGER              -- place among the phenomena, if it is one
) STRICT;

CREATE TABLE graph_tag (
  node     INTEGER NOT NULL REFERENCES graph_node (position) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  tag      TEXT NOT NULL,
  PRIMARY KEY (node, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE graph_value (              -- what the format does not know, kept
  node    INTEGER NOT NULL REFERENCES graph_node (position) ON DELETE CASCADE,
  name    TEXT NOT NULL,
  is_json INTEGER NOT NULL CHECK (is_json IN (0, 1)),
  value   TEXT NOT NULL,
  PRIMARY KEY (node, is_json, name)
) STRICT, WITHOUT ROWID;

CREATE TABLE graph_reference (
  node     INTEGER NOT NULL REFERENCES graph_node (position) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  parent   TEXT NOT NULL,
  author   TEXT NOT NULL,
  title    TEXT NOT NULL,
  url      TEXT NOT NULL,
  note     TEXT NOT NULL,
  raw      TEXT NOT NULL,
  PRIMARY KEY (node, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE graph_edge (
  position INTEGER PRIMARY KEY,
  parent   INTEGER NOT NULL REFERENCES graph_node (position) ON DELETE CASCADE,
  child    INTEGER NOT NULL REFERENCES graph_node (position) ON DELETE CASCADE,
  UNIQUE (parent, child)
) STRICT;

-- The relevance table. Its rows are items, so that requirements can follow from them.

CREATE TABLE cepra (
  only_row     INTEGER PRIMARY KEY CHECK (only_row = 1),
  tree         TEXT NOT NULL,
  graph_sha256 TEXT NOT NULL
) STRICT;

CREATE TABLE cepra_row (
  uid                  TEXT PRIMARY KEY REFERENCES item (uid) ON DELETE CASCADE,
  position             INTEGER NOT NULL,
  occurrence           INTEGER CHECK (occurrence BETWEEN 1 AND 10),
  occurrence_rationale TEXT NOT NULL,
  occurrence_expert    TEXT NOT NULL,
  impact               INTEGER CHECK (impact BETWEEN 1 AND 10),
  impact_rationale     TEXT NOT NULL,
  impact_expert        TEXT NOT NULL,
  suspect              TEXT NOT NULL,
  gone                 INTEGER NOT NULL CHECK (gone IN (0, 1)),
  notes                TEXT NOT NULL
) STRICT;

CREATE TABLE cepra_node (               -- the path of effects, then the causes
  row_uid  TEXT NOT NULL REFERENCES cepra_row (uid) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  id       TEXT NOT NULL,
  title    TEXT NOT NULL,
  kind     TEXT NOT NULL,
  PRIMARY KEY (row_uid, position)
) STRICT, WITHOUT ROWID;

-- What the acceptance runs found.

CREATE TABLE test_run (
  number          INTEGER PRIMARY KEY AUTOINCREMENT,
  id              TEXT NOT NULL UNIQUE,
  started_at      TEXT NOT NULL,
  program_version TEXT NOT NULL
) STRICT;

CREATE TABLE verdict (
  number     INTEGER PRIMARY KEY AUTOINCREMENT,
  run        INTEGER NOT NULL REFERENCES test_run (number) ON DELETE CASCADE,
  test_uid   TEXT,                      -- stays when the test is removed: it may come back
  test_id    TEXT NOT NULL,             -- shown at that time
  verdict    TEXT NOT NULL CHECK (verdict IN ('passed', 'failed', 'error', 'skipped')),
  text       TEXT NOT NULL,
  evaluation TEXT NOT NULL,
  report     TEXT NOT NULL
) STRICT;
CREATE INDEX verdict_of_run ON verdict (run);
CREATE INDEX verdict_of_test ON verdict (test_uid);

CREATE TABLE verdict_sample (
  number   INTEGER PRIMARY KEY AUTOINCREMENT,
  of       INTEGER NOT NULL REFERENCES verdict (number) ON DELETE CASCADE,
  sample   TEXT NOT NULL,
  verdict  TEXT NOT NULL CHECK (verdict IN ('passed', 'failed', 'error', 'skipped')),
  value    REAL,
  bound    REAL,
  text     TEXT NOT NULL
) STRICT;
CREATE INDEX sample_of_verdict ON verdict_sample (of);

CREATE TABLE verdict_value (            -- NULL: not a number
  sample INTEGER NOT NULL REFERENCES verdict_sample (number) ON DELETE CASCADE,
  name   TEXT NOT NULL,
  value  REAL,
  PRIMARY KEY (sample, name)
) STRICT, WITHOUT ROWID;

CREATE TABLE verdict_file (
  of       INTEGER NOT NULL REFERENCES verdict (number) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  path     TEXT NOT NULL,
  sha256   TEXT NOT NULL,
  PRIMARY KEY (of, position)
) STRICT, WITHOUT ROWID;
