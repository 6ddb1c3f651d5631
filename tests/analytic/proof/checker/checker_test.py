"""The checker accepts what the prover proves, and nothing that is changed. Environment: PROVE, ROCKSTACK_SOURCE; THOROUGH for more."""
from __future__ import annotations

import json
import os
import subprocess
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

import intervals
from check import Checker, accept, bits_for, check_table
from intervals import Complex, Real, Unproved, complex_sine_cosine, sine_cosine
from mutations import Replay
from scene import read_scene
from steps import Claim

COMPARISONS = Path(os.environ["ROCKSTACK_SOURCE"], "comparisons")
THOROUGH = "THOROUGH" in os.environ


def proved(scene: str, *options: str) -> tuple[Claim, str]:
    """A certificate and a table."""
    with tempfile.TemporaryDirectory() as folder:
        files = [Path(folder, "certificate.json"), Path(folder, "table.csv")]
        subprocess.run([os.environ["PROVE"], COMPARISONS / f"scenes/{scene}.toml", *options, "--certificate", files[0],
                        "--table", files[1]], check=True, stdout=subprocess.DEVNULL)
        return json.loads(files[0].read_text()), files[1].read_text()


def scene_of(certificate: Claim, **changes: Fraction) -> object:
    scene = read_scene(Path(certificate["scene"]), certificate["duration"])
    for key, value in changes.items():
        setattr(scene, key, value)
    return scene


CHATTER = "squat-top", "--bits", "160", "--slow", "1e-4"


class IntervalsTest(unittest.TestCase):
    def setUp(self):
        intervals.set_bits(200)

    def test_sines_and_cosines_keep_their_identities(self):
        for angle in (Fraction(1, 10), Fraction(-7, 3), Fraction(123), Fraction(0)):
            sine, cosine = sine_cosine(Real.of(angle))
            double, _ = sine_cosine(Real.of(2 * angle))
            for found, wanted in ((sine * sine + cosine * cosine, intervals.one()), (sine * cosine + sine * cosine, double)):
                self.assertLessEqual(abs(found.m - wanted.m), found.r + wanted.r)
                self.assertLess(found.r, 1 << 30)  # a half angle loses two bits, and 246 needs twelve

    def test_wide_intervals_hold_what_members_give(self):
        for centre in range(-8, 9):
            for radius in (Fraction(1, 1000), Fraction(1, 2), Fraction(7, 5), Fraction(3)):
                wide = sine_cosine(Real.of(Fraction(centre)).plus_minus(Real.of(radius).m))
                for part in range(-4, 5):
                    for whole, member in zip(wide, sine_cosine(Real.of(centre + radius * part / 4)), strict=True):
                        self.assertLessEqual(whole.lower, member.upper)
                        self.assertGreaterEqual(whole.upper, member.lower)

    def test_complex_sines_hold_those_of_the_boundary(self):
        disc = Complex.disc(Real.of(Fraction(2)), Real.of(Fraction(1, 2)))
        sine, cosine = complex_sine_cosine(disc)
        # sin(2 + i/2) = sin 2 cosh ½ + i cos 2 sinh ½, to ten digits
        for found, real, imaginary in ((sine, "1.0253473886", "-0.2168548628"), (cosine, "-0.4692580115", "-0.4738306204")):
            for part, text in ((found.re, real), (found.im, imaginary)):
                self.assertTrue(part.lower <= Real.of(Fraction(text)).m <= part.upper)

    def test_quotients_and_roots_come_back(self):
        a, b = Real.of(Fraction(7, 3)).plus_minus(1000), Real.of(Fraction(-5, 9)).plus_minus(3000)
        for found in (a / b * b, intervals.root(a) * intervals.root(a)):
            self.assertTrue(found.lower <= a.lower and a.upper <= found.upper)
        with self.assertRaises(Unproved):
            a / (b - b)


class CheckerTest(unittest.TestCase):
    def replay(self, *options: str) -> Replay:
        certificate, _ = proved(*options)
        return Replay(Checker(scene_of(certificate), bits_for(certificate)), certificate["inferences"])

    def test_an_accumulation_and_rest_are_accepted_with_their_table(self):
        certificate, table = proved(*CHATTER)
        checker = accept(certificate, scene_of(certificate))
        self.assertEqual(checker.events[-1].kind, "rest")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "table.csv")
            file.write_text(table)
            check_table(checker.events, file)
            rows = table.splitlines()
            cells = rows[1].split(",")
            cells[5] = cells[4]  # the upper bound of a time becomes the lower one
            file.write_text("\n".join([rows[0], ",".join(cells), *rows[2:]]) + "\n")
            with self.assertRaisesRegex(Unproved, "bounds hold number 0"):
                check_table(checker.events, file)

    def test_another_scene_refuses_the_certificate(self):
        certificate, _ = proved(*CHATTER)
        for key, value in (("gravity", Fraction("9.81") + Fraction(1, 10**30)), ("paper", True)):
            with self.assertRaises(Unproved, msg=key):
                accept(certificate, scene_of(certificate, **{key: value}))

    def test_a_certificate_without_a_claim_or_its_end_is_refused(self):
        certificate, _ = proved(*CHATTER)
        claims = certificate["inferences"]
        for place in (0, next(n for n, claim in enumerate(claims) if claim["kind"] == "impact"), len(claims) - 1):
            with self.assertRaises(Unproved, msg=place):
                accept(certificate | {"inferences": claims[:place] + claims[place + 1:]}, scene_of(certificate))

    def test_mutations_are_refused(self):
        scenes = [CHATTER] + [("shaken-block", "--bits", "192"), ("spanos-free-rocking", "--bits", "192", "--events", "8")] * THOROUGH
        counts = [80, 60, 60] if THOROUGH else [18]
        for seed, (options, count) in enumerate(zip(scenes, counts, strict=True)):
            for name, place, refusal in self.replay(*options).mutations(count, seed):
                with self.subTest(f"{options[0]}: {name} of claim {place + 1}"):
                    self.assertIsNotNone(refusal)

    @unittest.skipUnless(THOROUGH, "thorough")
    def test_shipped_tables_are_what_is_proved(self):
        for scene, *options in (("shaken-block", "--bits", "256"), ("pulse-block", "--bits", "256"),
                                ("squat-top", "--bits", "384", "--slow", "1e-20"), ("three-drums", "--bits", "384")):
            certificate, _ = proved(scene, *options)
            checker = accept(certificate, scene_of(certificate))
            check_table(checker.events, COMPARISONS / f"canon/proved/{scene}.csv")


if __name__ == "__main__":
    unittest.main()
