"""The benchmark of the diagnosis: its statistics, its rules, and one tiny case from beginning to end.

python3 withheld_test.py [unittest options]; FIDELIS_BIN names the folder of the programs (else the end-to-end test is skipped).
"""

import os
import random
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench" / "withheld"))

import ablation
import baselines
import build
import calibration
import cases
import chance
import distance
import effects
import packages
import recorded
import report
import run
import scenes
import score
import sensors
import sets
import severity
import standing


class Chance(unittest.TestCase):
    def test_wilson_interval_of_a_published_example(self):
        # Newcombe 1998, Stat. Med. 17, 857, table I, method 3 (score): 81/263 and 15/148, 0/20, 1/29.
        for hits, trials, low, high in ((81, 263, 0.2553, 0.3662), (15, 148, 0.0624, 0.1605), (0, 20, 0.0, 0.1611), (1, 29, 0.0061, 0.1718)):
            found = chance.wilson(hits, trials)
            self.assertAlmostEqual(found[0], low, 4)
            self.assertAlmostEqual(found[1], high, 4)

    def test_without_trials_anything_is_possible(self):
        self.assertEqual(chance.wilson(0, 0), (0.0, 1.0))

    def test_calibration_error_by_hand(self):
        # Bin 0.9…1: mean confidence 0.95, 1 of 2 right; bin 0.2…0.3: 0.25, 0 of 2. (2·0.45 + 2·0.25)/4 = 0.35.
        self.assertAlmostEqual(chance.expected_calibration_error([0.92, 0.98, 0.25, 0.25], [True, False, False, False]), 0.35)

    def test_full_confidence_that_is_always_right_is_calibrated(self):
        self.assertEqual(chance.expected_calibration_error([1.0] * 5, [True] * 5), 0.0)

    def test_true_confidences_are_off_by_chance_as_worked_out_by_hand(self):
        self.assertEqual(chance.calibration_error_by_chance([1.0, 0.0]), 0.0)
        self.assertAlmostEqual(chance.calibration_error_by_chance([0.5, 0.5]), 0.25)  # |0 - 1|, |1 - 1|, |2 - 1| at 1/4, 1/2, 1/4, of two
        self.assertAlmostEqual(chance.calibration_error_by_chance([0.5, 0.25]), (0.5 + 2 * 0.25 * 0.75) / 2)  # each in a bin of its own
        self.assertIsNone(chance.calibration_error_by_chance([]))

    def test_true_confidences_are_off_by_chance_as_often_as_when_they_are_drawn(self):
        rng = random.Random(5)
        told = [rng.uniform(0.3, 0.97) for _ in range(60)]
        drawn = [chance.expected_calibration_error(told, [rng.random() < c for c in told]) for _ in range(4000)]
        self.assertAlmostEqual(chance.calibration_error_by_chance(told), sum(drawn) / len(drawn), delta=0.002)  # four standard errors


class Distance(unittest.TestCase):
    def test_pure_offset_is_all_bias(self):
        bias, scatter = distance.double_validation([1.0, 2.0, 3.0], [1.5, 2.5, 3.5])
        self.assertAlmostEqual(bias, 0.5)
        self.assertAlmostEqual(scatter, 0.0)

    def test_same_mean_is_all_scatter(self):
        # EDFs of {0} and {-1, 1}: apart by one half over a length of two.
        bias, scatter = distance.double_validation([0.0], [-1.0, 1.0])
        self.assertAlmostEqual(bias, 0.0)
        self.assertAlmostEqual(scatter, 1.0)

    def test_a_lost_echo_moves_no_measurand_of_the_beams_that_both_have(self):
        table = lambda beams: {"layer": [0] * len(beams) * 4, "echo": [1] * len(beams) * 4,
                               "azimuth_rad": [a for a, _ in beams for _ in range(4)], "range_m": [r for _, r in beams for _ in range(4)]}
        measurands = [{"name": "range", "column": "range_m"}]
        parts = distance.beam_by_beam(measurands, table([(0.0, 10.0), (0.1, 50.0)]), table([(0.0, 10.25)]), 4)
        self.assertAlmostEqual(parts["range"], 0.25)  # means of the whole samples differ by 20 m
        self.assertAlmostEqual(parts["existence"], 0.5)  # one echo a shot more, in one of two beams

    def test_half_of_the_echoes_missing(self):
        full = {"layer": [0, 0], "azimuth_rad": [0.01, 0.5]}
        self.assertEqual(distance.existence({"layer": [0], "azimuth_rad": [0.01]}, full, 1), (0.5, 0.0))


def measured(rng, beams, shift=0.0, lost=()):
    """Two layers of `beams` beams, 20 frames of them: ranges of 10 m that scatter by 0.02 m; those of layer 1 are moved by `shift`."""
    rows = [(frame, layer, 0.01 * i, 10.0 + rng.gauss(0, 0.02) + (shift if layer else 0.0)) for layer in (0, 1) for i in range(beams)
            for frame in range(20) if i not in lost or frame % 2]
    frames, layers, azimuths, ranges = zip(*rows)
    return {"frame": list(frames), "layer": list(layers), "azimuth_rad": list(azimuths), "echo": [1] * len(rows), "range_m": list(ranges)}


class Standing(unittest.TestCase):
    EXPERIMENT = {"samples": [{"id": "s", "frames": 20}], "measurands": [{"name": "range", "column": "range_m", "resolution": 0.001}]}

    def found(self, real, simulated):
        return standing.measurands(self.sizes(real, simulated))

    def sizes(self, real, simulated):
        return standing.sizes(self.EXPERIMENT, {"s": real}, {"s": simulated})

    def test_noise_stands_out_nowhere(self):
        rng = random.Random(3)
        self.assertEqual(self.found(measured(rng, 100), measured(rng, 100)), [])

    def test_one_layer_that_is_off_by_half_of_the_noise_stands_out(self):
        rng = random.Random(3)
        self.assertEqual(self.found(measured(rng, 100, 0.01), measured(rng, 100)), ["range"])

    def test_what_is_sure_but_smaller_than_a_tenth_of_the_noise_does_not(self):
        rng = random.Random(3)
        real, simulated = measured(rng, 2000, 0.0015), measured(rng, 2000)
        self.assertEqual(self.found(real, simulated), [])  # 11 standard errors in its layer
        self.assertEqual(list(self.sizes(real, simulated)), ["range"])

    def test_a_few_beams_that_lose_every_second_echo_are_a_gap_of_existence_alone(self):
        rng = random.Random(3)
        self.assertEqual(self.found(measured(rng, 100, lost=range(10, 20)), measured(rng, 100)), ["existence"])


    def test_one_echo_more_is_no_gap_but_many_in_all_samples_are(self):
        rng = random.Random(3)
        plain = measured(rng, 100)
        more = {name: values + [values[0]] for name, values in plain.items()}
        several = {"samples": [{"id": str(i), "frames": 20} for i in range(40)], "measurands": []}
        self.assertEqual(self.found(more, plain), [])
        found = standing.sizes(several, {str(i): more for i in range(40)}, {str(i): plain for i in range(40)})
        self.assertEqual(standing.measurands(found), ["existence"])


class Recorded(unittest.TestCase):
    def package(self, folder):
        rng = random.Random(5)
        scene = scenes.range_sweep(rng)
        profile = sensors.draw(rng, scene)
        experiment, _ = cases.package(rng, scene, profile)
        packages.write(Path(folder) / "sweep" / "experiment.json", experiment)
        packages.write(Path(folder) / "sweep" / "model.json", {"format": "fidelis-model", "version": 1, "id": "m", "sensor": profile,
                                                               "rays_per_beam": [11, 11], "seed": 3, "effects": {"beam-divergence": {}}})
        return scene, experiment

    def test_cases_keep_the_scene_and_the_sensor_of_a_package_but_not_its_name_nor_its_roles(self):
        with tempfile.TemporaryDirectory() as folder:
            scene, experiment = self.package(folder)
            given = recorded.read(Path(folder))
            self.assertEqual([g.name for g in given], ["sweep"])
            self.assertEqual(recorded.scene_of(given[0]).shows, {"edges", "ranges"})
            self.assertEqual(recorded.scene_of(given[0]).reach_m, max(p["range_m"] for p, _ in scene.samples))
            draft = cases.draw(1, ("effect", "range-offset", 1), "0", given)
            self.assertEqual((draft.experiment["scene"], draft.experiment["sensor"]), (experiment["scene"], experiment["sensor"]))
            self.assertEqual(draft.experiment["id"], "case")
            roles = lambda e: [s["role"] for s in e["samples"]]
            self.assertEqual(sorted(roles(draft.experiment)), sorted(roles(experiment)))
            self.assertNotEqual(roles(draft.experiment), roles(experiment))
            self.assertEqual(draft.names, ["range-offset"])

    def test_what_its_scene_cannot_show_is_not_drawn(self):
        with tempfile.TemporaryDirectory() as folder:
            self.package(folder)
            with self.assertRaises(cases.Impossible):
                cases.draw(1, ("effect", "blooming", 1), "0", recorded.read(Path(folder)))


class Worlds(unittest.TestCase):
    def test_a_sample_without_detections_is_a_table_without_rows(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "none.csv"
            path.write_text("frame,time_s,layer,azimuth_rad,elevation_rad,echo,range_m\n")
            table = packages.read_table(path)
            self.assertEqual((table["layer"], table["range_m"]), ([], []))
            self.assertEqual(distance.existence({"layer": [1], "azimuth_rad": [0.0]}, table, 1), (0.0, 1.0))

    def test_an_offset_holds_in_its_setup_only(self):
        experiment = {"scene": [{"x": 1.0}], "samples": [
            {"id": "a", "patch": [{"op": "replace", "path": "/scene/0/x", "value": 5.0}]}, {"id": "b", "setup": "s", "patch": []}]}
        world = cases.packages.displaced(experiment, {"/scene/0/x": {"everywhere": 0.5, "per_setup": {"s": 0.25}}})
        self.assertEqual([packages.value_in(world, s, "/scene/0/x") for s in world["samples"]], [5.5, 1.75])
        self.assertEqual(experiment["samples"][1]["patch"], [])

    def test_set_ups_stand_within_what_is_recorded_of_them(self):
        experiment = {"scene": [{"x": 1.0}], "samples": [{"id": str(i), "patch": []} for i in range(500)]}
        world = cases.scattered(random.Random(1), experiment, {"/scene/0/x": 0.005})
        offsets = [packages.value_in(world, s, "/scene/0/x") - 1.0 for s in world["samples"]]
        self.assertLessEqual(max(map(abs, offsets)), 0.005 * cases.SIGMAS_KNOWN + 1e-9)
        self.assertGreater(sum(abs(x) > 0.005 for x in offsets), 100)  # a third of a normal distribution

    def test_slots_do_not_depend_on_how_many_are_taken(self):
        import itertools
        self.assertEqual(list(itertools.islice(cases.slots(3), 5)), list(itertools.islice(cases.slots(3), 50))[:5])

    def test_every_effect_of_the_list_can_be_drawn_somewhere(self):
        rng = random.Random(1)
        drawn = set()
        for _ in range(40):
            for family in scenes.FAMILIES.values():
                scene = family(rng)
                profile = sensors.draw(rng, scene)
                for name in effects.LIBRARY:
                    if effects.possible(name, scene, profile):
                        drawn.add(name)
                        recipe = effects.LIBRARY[name][1](rng, cases.context_of(scene, profile))
                        self.assertIsInstance(recipe(0.0), dict)
                        self.assertIsInstance(recipe(1.0), dict)
        self.assertEqual(drawn, set(effects.LIBRARY))

    def test_a_cause_that_changes_nothing_has_no_severity(self):
        def simulate(experiment, model, seed, *_):
            rng = random.Random(seed)
            return {s["id"]: measured(rng, 5) for s in experiment["samples"]}
        rng = random.Random(4)
        scene = scenes.range_sweep(rng)
        profile = sensors.draw(rng, scene)
        experiment, _ = cases.package(rng, scene, profile)
        draft = cases.Draft(experiment, {"effects": {}}, "range-sweep", "effect", ["dead-time"], lambda u: cases.Cause({"dead-time": {}}), {})
        with mock.patch.object(build.worlds, "simulate", simulate):
            self.assertEqual(build.Lab(draft, rng, "", "own").severity_of(1.0, 2)["value"], 0.0)

    def test_severity_bins(self):
        self.assertEqual([severity.bin_of(s) for s in (0.1, 0.5, 1.0, 2.0, 4.0, 99.0)], [None, 0.5, 1, 2, 4, 4])


def verdict(kind, names, confidence=0.9, same=()):
    return {"kind": kind, "names": list(names), "confidence": confidence, "indistinguishable_from": list(same)}


def truth(kind, *names):
    return {"kind": kind, "names": list(names), "parameters": {}, "where": {}, "measurands": []}


class Rules(unittest.TestCase):
    def test_the_effect_itself_is_right(self):
        self.assertTrue(score.named_first(truth("effect", "speckle"), verdict("effect", ["speckle"])))

    def test_a_set_of_two_counts_and_a_set_of_three_does_not(self):
        self.assertTrue(score.named_first(truth("effect", "a"), verdict("effect", ["b"], same=["a"])))
        self.assertFalse(score.named_first(truth("effect", "a"), verdict("effect", ["b"], same=["a", "c"])))

    def test_an_effect_is_no_answer_to_a_wrong_reference(self):
        self.assertFalse(score.named_first(truth("reference", "/scene/0/pose/position_m/0"), verdict("effect", ["range-offset"])))

    def test_half_of_a_pair_is_not_the_pair(self):
        self.assertFalse(score.named_first(truth("effect", "a", "b"), verdict("effect", ["a"], same=["b"])))
        self.assertTrue(score.named_first(truth("effect", "a", "b"), verdict("effect", ["b", "a"])))

    def test_pairs_are_counted_by_the_severity_of_their_weaker_member(self):
        rows = [{**score.judge({"id": "1", "class": "pair", "name": "two", "family": "street", "generator": "own", "truth": truth("effect", "a", "b"),
                                "severity": {"value": 9, "bin": 4, "members": {"a": 8.0, "b": weaker}}},
                               {"status": "done", "elapsed_s": 1.0, "report": {"verdict": verdict("effect", found)}}), "peak_mib": 1}
                for weaker, found in ((2.0, "ab"), (3.0, "a"), (1.9, "a"))]
        shown = {what: (result["value"], result["n"]) for what, _, result in score.table(rows)}
        self.assertEqual(shown["pair: both found, each with s >= 2 beside the other"], (0.5, 2))
        self.assertEqual(shown["pair: both found, the weaker one with s < 2"], (0.0, 1))

    def test_how_often_a_kind_of_verdict_is_right_is_counted_by_what_it_says(self):
        rows = [{**score.judge({"id": "1", "class": "pair", "name": "two", "family": "street", "generator": "own", "truth": truth("effect", *really),
                                "severity": {"value": 9, "bin": 4}},
                               {"status": "done", "elapsed_s": 1.0, "report": {"verdict": said}}), "peak_mib": 1}
                for really, said in (("ab", verdict("effect", "a")), ("a", verdict("effect", "a")), ("ab", verdict("effect", "ab")),
                                     ("a", verdict("none", [])))]
        shown = {what.split(": ")[-1]: (result["value"], result["n"]) for what, _, result in score.table(rows) if "of this kind" in what}
        self.assertEqual(shown, {"one effect": (0.5, 2), "two effects": (1.0, 1), "none": (0.0, 1), "unknown": (None, 0), "parameter": (None, 0),
                                 "reference": (None, 0)})

    def test_none_and_unknown_are_kinds(self):
        self.assertTrue(score.named_first(truth("none"), verdict("none", [])))
        self.assertFalse(score.named_first(truth("unknown"), verdict("none", [])))

    def test_a_crash_counts_as_wrong_and_is_counted(self):
        case = {"id": "1", "class": "effect", "name": "speckle", "family": "street", "generator": "own", "severity": {"value": 3, "bin": 4},
                "truth": truth("effect", "speckle")}
        row = score.judge(case, {"status": "failed", "elapsed_s": 1.0})
        rows = dict((what, result) for what, _, result in score.table([row]))
        self.assertEqual((rows["right cause first, s >= 2"]["value"], rows["right cause first, s >= 2"]["n"]), (0.0, 1))
        self.assertEqual(rows["without a verdict (crash, time-out)"]["value"], 1.0)

    def test_laws_that_no_library_has_and_effects_taken_out_of_it_are_counted_together_and_apart(self):
        rows = [{**score.judge(case_of(str(i), class_name, (), "unknown"), result_of(said=said)), "peak_mib": 1} for i, (class_name, said) in enumerate(
            (("outside", ("unknown", [])), ("outside", ("effect", ["speckle"], 0.5)), ("removed", ("effect", ["speckle"]))))]
        shown = {what: result["value"] for what, _, result in score.table(rows)}
        for who, flagged, wrong in (("outside the library", 1 / 3, 1 / 3), ("a law that no library has", 0.5, 0.0),
                                    ("an effect taken out of the library", 0.0, 1.0)):
            self.assertAlmostEqual(shown[who + ": flagged as unknown"], flagged)
            self.assertAlmostEqual(shown[who + ": confidently wrong"], wrong)

    def test_where_a_sector_was_calibrated_away_no_stratum_is_the_right_one(self):
        rows = [{**score.judge(case_of(str(i), class_name), result_of()), "peak_mib": 1, "stratum": found}
                for i, (class_name, found) in enumerate((("effect", True), ("hidden", False)))]
        shown = {what: (result["value"], result["n"]) for what, _, result in score.table(rows)}
        self.assertEqual(shown["where: right stratum, where the truth has one"], (1.0, 1))

    def test_a_beam_in_a_narrow_sector_is_its_stratum_if_it_holds_half_of_the_gap(self):
        row = {"stratum": [0.5, 0.5], "share": 0.9}
        self.assertTrue(score.is_stratum(row, [0.4, 0.6]))
        self.assertFalse(score.is_stratum({**row, "share": 0.3}, [0.4, 0.6]))
        self.assertFalse(score.is_stratum(row, [0.6, 0.8]))
        self.assertFalse(score.is_stratum({"stratum": [0.5, 1.7], "share": 1.0}, [0.4, 0.6]))

    def test_strata_overlap(self):
        self.assertAlmostEqual(score.overlap([0, 2], [1, 3]), 1 / 3)
        self.assertEqual(score.overlap(["wall"], ["wall"]), 1.0)

    def test_the_report_names_what_went_wrong(self):
        case = {"id": "0042", "class": "none", "name": "quiet", "family": "street", "generator": "own", "severity": {"value": 0, "bin": None},
                "truth": truth("none")}
        row = score.judge(case, {"status": "done", "elapsed_s": 1.0, "report": {"verdict": verdict("effect", ["speckle"]), "causes": []}})
        page = report.markdown([row], [("random", {"all classes": {"value": 0.02, "interval": None, "n": 1}})], {"date": "d", "version": "v", "command": "c", "generators": "1 own"})
        self.assertIn("| 0042 | none | none |", page)
        self.assertIn("effect: speckle", page)


def listed(kind, name="", bic=0.0, similarity=None):
    return {"kind": kind, "name": name, "variant": "", "explained": 0.0, "bic": bic, "similarity": similarity}


def case_of(number, class_name="effect", names=("speckle",), kind="effect", oracle=None, generator="foreign"):
    told = truth(kind, *names)
    told["oracle"] = None if oracle is None else {"shrink": oracle}
    return {"id": number, "class": class_name, "name": "+".join(names), "family": "street", "generator": generator, "without": [],
            "severity": {"value": 3, "bin": 4}, "truth": told}


def result_of(*tried, said=("effect", ["speckle"]), causes=(), actual=None):
    result = {"status": "done", "elapsed_s": 1.0, "report": {"verdict": verdict(*said), "causes": list(causes)}, "tried": list(tried)}
    return result if actual is None else {**result, "actual": {"shrink": actual}}


class Judges(unittest.TestCase):
    TRIED = (listed("none", bic=90.0), listed("effect", "speckle", 40.0, 0.2), listed("effect", "range-walk", 50.0, 0.9),
             listed("parameter", "/sensor/receiver/noise_w", 60.0, -0.5))

    def test_bic_takes_the_smallest_and_the_signature_the_nearest(self):
        self.assertEqual(baselines.smallest_bic(result_of(*self.TRIED))["names"], ["speckle"])
        self.assertEqual(baselines.nearest_signature(result_of(*self.TRIED))["names"], ["range-walk"])

    def test_bic_may_say_that_nothing_is_missing(self):
        self.assertEqual(baselines.smallest_bic(result_of(listed("none", bic=10.0), listed("effect", "speckle", 11.0))), baselines.answer("none", []))

    def test_a_recalibration_beside_an_effect_is_not_named(self):
        pair = listed("pair", "/sensor/emitter/peak_power_w + speckle", 1.0)
        self.assertEqual(baselines.smallest_bic(result_of(*self.TRIED, pair)), baselines.answer("effect", ["speckle"]))

    def test_a_program_without_a_list_is_not_held_against_its_judges(self):
        old = result_of()
        del old["tried"]
        self.assertIsNone(baselines.judged(case_of("1"), old, baselines.smallest_bic, "tried"))
        self.assertFalse(baselines.judged(case_of("1"), {"status": "timeout"}, baselines.smallest_bic, "tried"))

    def test_the_largest_claim_is_right_by_luck_only(self):
        causes = [{"kind": "effect", "name": "speckle", "shrink": {"fraction": 0.3}}, {"kind": "effect", "name": "a", "shrink": {"fraction": 0.4}}]
        self.assertEqual(baselines.largest_shrink(result_of(causes=causes))["names"], ["a"])
        self.assertFalse(score.named_first(truth("none"), baselines.largest_shrink(result_of())))

    def test_the_oracle_is_reached_at_97_hundredths_and_not_asked_where_it_brings_nothing(self):
        case = case_of("1", oracle=0.5)
        self.assertTrue(baselines.oracle_reached(case, result_of(actual=0.78), result_of(actual=0.8)))
        self.assertFalse(baselines.oracle_reached(case, result_of(actual=0.77), result_of(actual=0.8)))
        self.assertFalse(baselines.oracle_reached(case, result_of(), result_of()))  # 0.5 at the true values was to be had
        self.assertIsNone(baselines.oracle_reached(case_of("2", oracle=-0.1), result_of(actual=0.2), result_of()))
        self.assertIsNone(baselines.oracle_reached(case, result_of(actual=0.2), None))

    def test_cases_in_which_two_programs_differ_are_shown_apart_and_counted_in_all(self):
        made = [case_of("1", oracle=0.9), case_of("2", oracle=-0.2), case_of("3", oracle=-0.2, generator="own"), case_of("4", "none", (), "none")]
        results = {c["id"]: result_of(*self.TRIED) for c in made}
        rows = [score.judge(c, results[c["id"]]) for c in made]
        self.assertEqual([score.programs_differ(r) for r in rows], [False, True, False, False])
        room = {c["id"]: {"materials": {"a": {}}, "scene": [{}]} for c in made}
        table = dict(baselines.table(rows, made, results, {}, room, ["speckle", "range-walk"]))
        sizes = {group: rate["n"] for group, rate in table["this diagnosis"].items()}
        self.assertEqual((sizes["all classes"], sizes["all classes, programs agree"], sizes["programs differ by more than the cause"]), (4, 3, 1))
        self.assertEqual(table["BIC, errors taken for independent"]["one effect"]["value"], 1.0)
        self.assertEqual(table["nearest signature"]["one effect"]["value"], 0.0)
        self.assertEqual(table["oracle: names the true effect"]["one effect"]["n"], 0)
        self.assertIn("BIC, errors taken for independent", baselines.too_close(list(table.items())))


class Ablations(unittest.TestCase):
    def test_one_channel_is_the_range_with_the_same_measurements(self):
        with tempfile.TemporaryDirectory() as folder:
            whole = Path(folder) / "whole"
            (whole / "measurements").mkdir(parents=True)
            (whole / "measurements" / "a.csv").write_text("x")
            packages.write(whole / "experiment.json", {"measurands": [{"name": "epw"}, {"name": "range"}]})
            part = ablation.with_one_channel(whole, Path(folder) / "part")
            self.assertEqual(packages.read(part / "experiment.json"), {"measurands": [{"name": "range"}]})
            self.assertEqual((part / "measurements" / "a.csv").read_text(), "x")
            self.assertEqual(len(packages.read(whole / "experiment.json")["measurands"]), 2)

    def test_lost_and_won_are_counted_case_by_case(self):
        right, wrong = result_of(said=("effect", ["speckle"])), result_of(said=("effect", ["blooming"]))
        rows = lambda *results: {str(i): score.judge(case_of(str(i)), r) for i, r in enumerate(results)}
        lines = ablation.table({"full": rows(right, right, wrong), "one-channel": rows(wrong, right, right, right)})
        self.assertEqual([(variant, lost, won) for variant, _, lost, won in lines], [("full", 0, 0), ("one-channel", 1, 1)])
        self.assertEqual(lines[1][1]["one effect"]["n"], 3)  # the fourth was not run as a whole
        self.assertIn("| one channel | 0.67 [0.21, 0.94] (3) |", ablation.markdown(lines, report.shown, {
            "date": "d", "version": "v", "command": "c", "generators": "3 foreign"}))


class Sets(unittest.TestCase):
    def test_sets_of_fresh_cases_are_kept_pooled_and_shown_beside_each_other(self):
        row = lambda number, *said: score.judge(case_of(number), result_of(said=("effect", [*said])))
        about = lambda seed: {"date": "2026-01-02", "version": f"v{seed}", "command": f"scripts/withheld --seed {seed}", "generators": "2 foreign"}
        with tempfile.TemporaryDirectory() as folder:
            sets.keep(Path(folder), about(9), [row("1", "speckle"), row("2", "blooming")])
            sets.keep(Path(folder), about(10), [row("3", "speckle")])
            kept = sets.read(Path(folder))
        self.assertEqual([s["version"] for s in kept], ["v10", "v9"])
        lines = {line.split(" | ")[0]: line for line in sets.markdown(kept)}
        low, high = chance.wilson(2, 3)
        pooled = f"0.67 [{low:.2f}, {high:.2f}], n=3"
        self.assertIn(f"| {pooled} | {pooled} | 1.00 (1) | 0.50 (2) |", lines["| all classes: right"])

    def test_without_sets_the_page_says_nothing_of_them(self):
        self.assertEqual(report.sets_page([]), "")


class Calibration(unittest.TestCase):
    def test_verdicts_are_counted_by_what_they_said_and_how_far_they_were_believed(self):
        told = lambda confidence, right, *ties: {"kind": "effect", "found": ["speckle"], "confidence": confidence, "right": right, "equivalents": [*ties]}
        low, high = chance.wilson(1, 2)
        self.assertEqual(list(calibration.lines([told(0.92, True), told(0.94, False), told(0.92, True, "blooming")])), [
            f"| one effect | 0.93 | 1 of 2 | 0.50 [{low:.2f}, {high:.2f}] |",
            f"| one effect, tied with one | 0.92 | 1 of 1 | 1.00 [{chance.wilson(1, 1)[0]:.2f}, 1.00] |"])


class EndToEnd(unittest.TestCase):
    def test_a_tiny_case_is_built_run_and_scored(self):
        if "FIDELIS_BIN" not in os.environ:
            self.skipTest("FIDELIS_BIN does not name the folder of the programs")
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(sensors, "log_uniform", lambda rng, low, high: low), \
                mock.patch.object(scenes, "FAMILIES", {"range-sweep": scenes.range_sweep}), mock.patch.object(cases.samples_of, "__defaults__", (5,)):
            slot = ("effect", "range-offset", 1)
            number, text = build.build(7, slot, folder, os.environ["FIDELIS_BIN"])
            self.assertIsNotNone(number, text)
            home = Path(folder) / number
            case = packages.read(home / "case.json")
            self.assertEqual((case["seed"], case["slot"]), (7, list(slot)))
            self.assertNotIn("range-offset", packages.read(home / "model.json")["effects"])
            self.assertNotIn("range-offset", (home / "experiment" / "experiment.json").read_text())
            result = run.diagnose(home, os.environ["FIDELIS_BIN"], "key", 300)
            self.assertEqual(result["status"], "done", result.get("message"))
            self.assertEqual(run.diagnose(home, "/nowhere", "key", 1), result)  # the second call reads
            self.assertEqual(result["tried"][0]["kind"], "none")
            self.assertIn("range-offset", [t["name"] for t in result["tried"]])
            row = score.judge(case, result)
            self.assertEqual(row["truth"], ["range-offset"])
            self.assertIn(row["kind"], ("none", "effect", "parameter", "reference", "unknown"))


if __name__ == "__main__":
    unittest.main()
