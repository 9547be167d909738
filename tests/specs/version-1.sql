-- A project as version 1 of the tables held it. Its content is that of small_project.cpp.
PRAGMA application_id = 1178881107;
PRAGMA user_version = 1;
PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE project (
  only_row    INTEGER PRIMARY KEY CHECK (only_row = 1),
  uid         TEXT NOT NULL,
  next_number INTEGER NOT NULL          -- of the next uid
) STRICT;
INSERT INTO project VALUES(1,'51049ab4961bc789ab3d0cfa3f5606d0f39c4c64278b47465e177bf9b4c28c13',8);
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
INSERT INTO item VALUES('1774ddc7-1153-8c84-a946-2093e1a5afc3','CEPRA row','r4705ca92186e','Range error','','','','under review');
INSERT INTO item VALUES('aecc85e8-b004-8721-a485-6b4c4521413f','CEPRA row','r2e0f13a643bb','Range error ← Attenuation by "aerosols"; <fog>','','','','under review');
INSERT INTO item VALUES('6fbc9763-50d1-8469-a37f-e93492d194b0','requirement','RangeError_Fog_1','Fog is modelled','','','','accepted');
INSERT INTO item VALUES('df4d277a-71af-8961-a483-f55e80e15274','requirement','RangeError_Fog_2','Range bias in fog',replace('The bias, in m,\nis "small"; see <1>.','\n',char(10)),'','','accepted');
INSERT INTO item VALUES('c5f0a813-f4c3-87f9-ae98-72f464f1341a','acceptance test','RangeError_Fog_3','Range bias at 10 m','','','','accepted');
INSERT INTO item VALUES('bd1be0e2-dc79-82bf-a285-41abdb1676f9','experiment data requirement','RangeError_Fog_4','Sweep','','','eve','under review');
INSERT INTO item VALUES('4b1060fb-386a-8c6a-a22f-b7f8bd21d874','reference data requirement','RangeError_Fog_5','True range','','','','under review');
CREATE TABLE requirement (
  uid     TEXT PRIMARY KEY REFERENCES item (uid) ON DELETE CASCADE,
  level   TEXT NOT NULL CHECK (level IN ('general', 'object-model', 'detection-model')),
  effects TEXT NOT NULL                 -- list: see joinList
) STRICT;
INSERT INTO requirement VALUES('6fbc9763-50d1-8469-a37f-e93492d194b0','general','atmospheric-attenuation');
INSERT INTO requirement VALUES('df4d277a-71af-8961-a483-f55e80e15274','detection-model','');
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
INSERT INTO acceptance_test VALUES('c5f0a813-f4c3-87f9-ae98-72f464f1341a','experiments/range-sweep','models/demo.json','range','','dvm','abs(d_bias) <= 0.005 * range_m','r10; odd\; sample; validation','20','note=a=b; rays=3\;5');
CREATE TABLE experiment_data (
  uid         TEXT PRIMARY KEY REFERENCES item (uid) ON DELETE CASCADE,
  experiment  TEXT NOT NULL,
  device      TEXT NOT NULL,
  conditions  TEXT NOT NULL,
  repetitions TEXT NOT NULL
) STRICT;
INSERT INTO experiment_data VALUES('bd1be0e2-dc79-82bf-a285-41abdb1676f9','','Ibeo LUX 2010','10 m to 20 m','');
CREATE TABLE reference_data (
  uid         TEXT PRIMARY KEY REFERENCES item (uid) ON DELETE CASCADE,
  quantity    TEXT NOT NULL,
  device      TEXT NOT NULL,
  uncertainty TEXT NOT NULL
) STRICT;
INSERT INTO reference_data VALUES('4b1060fb-386a-8c6a-a22f-b7f8bd21d874','','','± 2 mm (95 %)');
CREATE TABLE link (
  origin   TEXT NOT NULL REFERENCES item (uid) ON DELETE CASCADE,
  follower TEXT NOT NULL REFERENCES item (uid) ON DELETE CASCADE,
  suspect  INTEGER NOT NULL DEFAULT 0 CHECK (suspect IN (0, 1)),
  PRIMARY KEY (origin, follower),
  CHECK (origin <> follower)
) STRICT, WITHOUT ROWID;
INSERT INTO link VALUES('6fbc9763-50d1-8469-a37f-e93492d194b0','df4d277a-71af-8961-a483-f55e80e15274',0);
INSERT INTO link VALUES('aecc85e8-b004-8721-a485-6b4c4521413f','6fbc9763-50d1-8469-a37f-e93492d194b0',0);
INSERT INTO link VALUES('c5f0a813-f4c3-87f9-ae98-72f464f1341a','4b1060fb-386a-8c6a-a22f-b7f8bd21d874',0);
INSERT INTO link VALUES('c5f0a813-f4c3-87f9-ae98-72f464f1341a','bd1be0e2-dc79-82bf-a285-41abdb1676f9',0);
INSERT INTO link VALUES('df4d277a-71af-8961-a483-f55e80e15274','c5f0a813-f4c3-87f9-ae98-72f464f1341a',0);
CREATE TABLE change (                   -- outlives the item
  number  INTEGER PRIMARY KEY AUTOINCREMENT,
  uid     TEXT NOT NULL,
  id      TEXT NOT NULL,
  who     TEXT NOT NULL,
  changed TEXT NOT NULL,                -- when
  what    TEXT NOT NULL
) STRICT;
INSERT INTO change VALUES(1,'graph','graph','eve','2026-01-02T03:04:05Z','imported small.json, sha256 5f');
INSERT INTO change VALUES(2,'aecc85e8-b004-8721-a485-6b4c4521413f','r2e0f13a643bb','eve','2026-01-02T03:04:05Z','occurrence: none -> 7 by eve; occurrence rationale changed; impact: none -> 9 by adam; impact rationale changed');
INSERT INTO change VALUES(3,'6fbc9763-50d1-8469-a37f-e93492d194b0','RangeError_Fog_1','eve','2026-01-02T03:04:05Z','added');
INSERT INTO change VALUES(4,'df4d277a-71af-8961-a483-f55e80e15274','RangeError_Fog_2','eve','2026-01-02T03:04:05Z','added');
INSERT INTO change VALUES(5,'c5f0a813-f4c3-87f9-ae98-72f464f1341a','RangeError_Fog_3','eve','2026-01-02T03:04:05Z','added');
INSERT INTO change VALUES(6,'bd1be0e2-dc79-82bf-a285-41abdb1676f9','RangeError_Fog_4','eve','2026-01-02T03:04:05Z','added');
INSERT INTO change VALUES(7,'4b1060fb-386a-8c6a-a22f-b7f8bd21d874','RangeError_Fog_5','eve','2026-01-02T03:04:05Z','added');
INSERT INTO change VALUES(8,'aecc85e8-b004-8721-a485-6b4c4521413f','r2e0f13a643bb','eve','2026-01-02T03:04:05Z','linked to RangeError_Fog_1');
INSERT INTO change VALUES(9,'6fbc9763-50d1-8469-a37f-e93492d194b0','RangeError_Fog_1','eve','2026-01-02T03:04:05Z','linked to RangeError_Fog_2');
INSERT INTO change VALUES(10,'df4d277a-71af-8961-a483-f55e80e15274','RangeError_Fog_2','eve','2026-01-02T03:04:05Z','linked to RangeError_Fog_3');
INSERT INTO change VALUES(11,'c5f0a813-f4c3-87f9-ae98-72f464f1341a','RangeError_Fog_3','eve','2026-01-02T03:04:05Z','linked to RangeError_Fog_4');
INSERT INTO change VALUES(12,'c5f0a813-f4c3-87f9-ae98-72f464f1341a','RangeError_Fog_3','eve','2026-01-02T03:04:05Z','linked to RangeError_Fog_5');
CREATE TABLE graph (
  only_row INTEGER PRIMARY KEY CHECK (only_row = 1),
  tree     TEXT NOT NULL,
  source   TEXT NOT NULL,
  sha256   TEXT NOT NULL,
  who      TEXT NOT NULL,
  imported TEXT NOT NULL                -- when
) STRICT;
INSERT INTO graph VALUES(1,'small','small.json','5f','eve','2026-01-02T03:04:05Z');
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
INSERT INTO graph_node VALUES(0,'0','Range error','effect','Signal propagation','','','','',0,0);
INSERT INTO graph_node VALUES(1,'1','Attenuation by "aerosols"; <fog>','effect','Signal propagation','','','','',0,NULL);
INSERT INTO graph_node VALUES(2,'2','Emitter wavelength λ','designParameter','Signal propagation',replace('two\nlines','\n',char(10)),'[1, A, T, https://x.y, note]','1','',0,NULL);
INSERT INTO graph_node VALUES(3,'3','Number concentration','systemIndependent','Signal propagation','','','','',0,NULL);
CREATE TABLE graph_tag (
  node     INTEGER NOT NULL REFERENCES graph_node (position) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  tag      TEXT NOT NULL,
  PRIMARY KEY (node, position)
) STRICT, WITHOUT ROWID;
INSERT INTO graph_tag VALUES(2,0,'b');
INSERT INTO graph_tag VALUES(2,1,'a');
CREATE TABLE graph_value (              -- what the format does not know, kept
  node    INTEGER NOT NULL REFERENCES graph_node (position) ON DELETE CASCADE,
  name    TEXT NOT NULL,
  is_json INTEGER NOT NULL CHECK (is_json IN (0, 1)),
  value   TEXT NOT NULL,
  PRIMARY KEY (node, is_json, name)
) STRICT, WITHOUT ROWID;
INSERT INTO graph_value VALUES(2,'FMCWspecific',0,'true');
INSERT INTO graph_value VALUES(2,'x',1,'[1,2]');
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
INSERT INTO graph_reference VALUES(2,0,'1','A','T','https://x.y','note','1, A, T, https://x.y, note');
CREATE TABLE graph_edge (
  position INTEGER PRIMARY KEY,
  parent   INTEGER NOT NULL REFERENCES graph_node (position) ON DELETE CASCADE,
  child    INTEGER NOT NULL REFERENCES graph_node (position) ON DELETE CASCADE,
  UNIQUE (parent, child)
) STRICT;
INSERT INTO graph_edge VALUES(0,0,1);
INSERT INTO graph_edge VALUES(1,1,3);
INSERT INTO graph_edge VALUES(2,1,2);
INSERT INTO graph_edge VALUES(3,0,3);
CREATE TABLE cepra (
  only_row     INTEGER PRIMARY KEY CHECK (only_row = 1),
  tree         TEXT NOT NULL,
  graph_sha256 TEXT NOT NULL
) STRICT;
INSERT INTO cepra VALUES(1,'small','5f');
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
INSERT INTO cepra_row VALUES('1774ddc7-1153-8c84-a946-2093e1a5afc3',0,NULL,'','',NULL,'','','',0,'');
INSERT INTO cepra_row VALUES('aecc85e8-b004-8721-a485-6b4c4521413f',1,7,'fog is common','eve',9,'objects are missed','adam','',0,'');
CREATE TABLE cepra_node (               -- the path of effects, then the causes
  row_uid  TEXT NOT NULL REFERENCES cepra_row (uid) ON DELETE CASCADE,
  position INTEGER NOT NULL,
  id       TEXT NOT NULL,
  title    TEXT NOT NULL,
  kind     TEXT NOT NULL,
  PRIMARY KEY (row_uid, position)
) STRICT, WITHOUT ROWID;
INSERT INTO cepra_node VALUES('1774ddc7-1153-8c84-a946-2093e1a5afc3',0,'0','Range error','effect');
INSERT INTO cepra_node VALUES('1774ddc7-1153-8c84-a946-2093e1a5afc3',1,'3','Number concentration','systemIndependent');
INSERT INTO cepra_node VALUES('aecc85e8-b004-8721-a485-6b4c4521413f',0,'0','Range error','effect');
INSERT INTO cepra_node VALUES('aecc85e8-b004-8721-a485-6b4c4521413f',1,'1','Attenuation by "aerosols"; <fog>','effect');
INSERT INTO cepra_node VALUES('aecc85e8-b004-8721-a485-6b4c4521413f',2,'3','Number concentration','systemIndependent');
INSERT INTO cepra_node VALUES('aecc85e8-b004-8721-a485-6b4c4521413f',3,'2','Emitter wavelength λ','designParameter');
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
CREATE TABLE verdict_sample (
  number   INTEGER PRIMARY KEY AUTOINCREMENT,
  of       INTEGER NOT NULL REFERENCES verdict (number) ON DELETE CASCADE,
  sample   TEXT NOT NULL,
  verdict  TEXT NOT NULL CHECK (verdict IN ('passed', 'failed', 'error', 'skipped')),
  value    REAL,
  bound    REAL,
  text     TEXT NOT NULL
) STRICT;
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
CREATE INDEX link_back ON link (follower);
CREATE INDEX change_of ON change (uid);
CREATE INDEX verdict_of_run ON verdict (run);
CREATE INDEX verdict_of_test ON verdict (test_uid);
CREATE INDEX sample_of_verdict ON verdict_sample (of);
COMMIT;
