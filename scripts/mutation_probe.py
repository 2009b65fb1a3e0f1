#!/usr/bin/env python3
"""Do the tests notice when renderer/ is wrong? By hand: changes one operator or constant at a time and runs the room's
tests; what no test notices is listed.

    scripts/mutation_probe.py -n 30 --seed 1 --room gbuffer --room light    # rooms: folders of renderer/
    scripts/mutation_probe.py --again                                       # only the survivors of the last run
    scripts/mutation_probe.py -n 10 --room passes --gl                      # with the tests that need a context

Works on a copy of the tree below build/mutation, so the tree itself is never touched, however the run ends. A survivor
is a question, not yet a gap: the change may be equivalent, or a constant that is only tuned.
"""
import argparse
import contextlib
import json
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import asdict, dataclass

ROOT = pathlib.Path(__file__).resolve().parent.parent
TREE = ROOT / "build" / "mutation"
BUILD = TREE / "build" / "ci"
SURVIVORS = TREE / "build" / "survivors.json"
ROOMS = ["gbuffer", "light", "frame", "options", "truth", "scene"]
TESTS_OF = {"scene": ["test_scene_cpu", "test_scenes_cpu"]}  # where more than the room's mirror folder sees it


def number_off(match):
    text = match.group(0)
    return str(int(text) + 1) if text.isdigit() else repr(round(float(text) * 1.1, 12) or 1.0)


# What is looked for in a line without its strings and comments, and what stands there instead. Operators only with
# spaces around them: others are template brackets, references and signs.
SWAPS = [(a, b) for pair in [(" < ", " <= "), (" > ", " >= "), (" + ", " - "), (" * ", " / "), (" && ", " || "),
                             (" == ", " != "), (" += ", " -= "), (" *= ", " /= "), ("std::min", "std::max"),
                             ("std::floor(", "std::ceil("), ("true", "false"), ("++", "--")]
         for a, b in (pair, pair[::-1])]
RULES = [(re.compile(re.escape(a) if a[0] in " +-" else r"\b" + re.escape(a)), b) for a, b in SWAPS] + [
    (re.compile(r"(?<![\w=!])!(?=[\w(])"), ""),
    (re.compile(r"(?<![\w.\"])\d+(\.\d+)?(?![\w.])"), number_off),
]
SKIPPED = re.compile(r"^\s*(#|//|static_assert|assert\(|namespace|using |throw |template)")


@dataclass
class Mutant:
    file: str
    line: int  # from 1
    before: str
    after: str

    def __str__(self):
        return f"{self.file}:{self.line}\n    - {self.before.strip()}\n    + {self.after.strip()}"


def blanked(line):
    """The line with its strings, characters and comment blanked out, so that places stay where they are."""
    line = re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])+\'', lambda m: "\0" * len(m.group(0)), line)
    at = line.find("//")
    return line if at < 0 else line[:at]


def mutants_of(path):
    out = []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        code = blanked(line)
        if SKIPPED.match(line) or code.count("\0") > len(code) / 2:  # the latter: a row of texts
            continue
        for pattern, instead in RULES:
            for match in pattern.finditer(code):
                new = instead(match) if callable(instead) else instead
                if new != match.group(0):
                    out.append(Mutant(str(path.relative_to(TREE)), number, line,
                                      line[:match.start()] + new + line[match.end():]))
    return out


def copy_tree():
    """Files that differ are copied, those that are gone are removed: ninja then rebuilds what changed only."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True,
                            capture_output=True, text=True).stdout.split("\n")
    files = {name for name in listed if name and (ROOT / name).is_file()}
    for name in files:
        to = TREE / name
        if to.exists() and to.read_bytes() == (ROOT / name).read_bytes():
            continue
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, to)
    for path in TREE.rglob("*"):
        name = str(path.relative_to(TREE))
        if path.is_file() and not name.startswith("build/") and name not in files:
            path.unlink()


def run(command, seconds):
    """-> exit status and output; a run that is too long counts as a failure."""
    with subprocess.Popen(command, cwd=TREE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace", start_new_session=True) as process:
        try:
            output, _ = process.communicate(timeout=seconds)
            return process.returncode, output
        except BaseException as stop:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            if isinstance(stop, subprocess.TimeoutExpired):
                return 124, "took too long"
            raise


def build(tests):
    return run(["ninja", "-C", str(BUILD), *tests], 1200)


def tests_of(room, gl):
    known = subprocess.run(["ninja", "-C", str(BUILD), "-t", "targets", "all"], check=True, capture_output=True,
                           text=True).stdout
    wanted = TESTS_OF.get(room, [f"test_{room}_cpu"]) + ([f"test_{room}_gl"] if gl else [])
    tests = [t for t in wanted if re.search(rf"^{t}: ", known, re.MULTILINE)]
    if not tests:
        sys.exit(f"mutation_probe: no tests for the room '{room}'" + ("" if gl else " (with --gl?)"))
    return tests


def passed(tests, seconds):
    for test in tests:
        status, output = run([str(BUILD / test), "--gtest_brief=1", "--gtest_fail_fast"], seconds)
        if status != 0:
            return False, output
    return True, ""


def probe(mutant, tests, seconds):
    """-> killed, survived or uncompilable."""
    path = TREE / mutant.file
    original = path.read_text()
    lines = original.splitlines(keepends=True)
    if lines[mutant.line - 1].rstrip("\n") != mutant.before:
        sys.exit(f"mutation_probe: {mutant.file}:{mutant.line} has changed since; run anew without --again")
    lines[mutant.line - 1] = mutant.after + "\n"
    try:
        path.write_text("".join(lines))
        if build(tests)[0] != 0:
            return "uncompilable"
        return "survived" if passed(tests, seconds)[0] else "killed"
    finally:
        path.write_text(original)


def chosen(rooms, seed):
    """Mutants without end, in turn from each room; a seed always gives the same ones."""
    rng = random.Random(seed)
    pools = {}
    for room in rooms:
        pools[room] = [m for p in sorted((TREE / "renderer" / room).rglob("*.cpp")) for m in mutants_of(p)]
        rng.shuffle(pools[room])
    while any(pools.values()):
        for room in rooms:
            if pools[room]:
                yield room, pools[room].pop()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-n", type=int, default=30, help="how many mutants (default 30)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--room", action="append", help=f"a folder of renderer/; again for more (default {' '.join(ROOMS)})")
    parser.add_argument("--gl", action="store_true", help="the room's gl tests, too")
    parser.add_argument("--again", action="store_true", help="only what survived the last run")
    args = parser.parse_args()

    copy_tree()
    status, output = run(["cmake", "--preset", "ci"], 600)
    if status != 0:
        sys.exit(output)
    if args.again:
        mutants = iter([(m.pop("room"), Mutant(**m)) for m in json.loads(SURVIVORS.read_text())])
        args.n = sys.maxsize
    else:
        mutants = chosen(args.room or ROOMS, args.seed)
    tests, limit = {}, {}
    counts = {"killed": 0, "survived": 0, "uncompilable": 0}
    survivors = []
    try:
        for room, mutant in mutants:
            if counts["killed"] + counts["survived"] >= args.n:
                break
            if room not in tests:
                tests[room] = tests_of(room, args.gl)
                status, output = build(tests[room])
                begun = time.monotonic()
                good, failure = passed(tests[room], 1200) if status == 0 else (False, output)
                if not good:
                    sys.exit(f"mutation_probe: {room} fails without any mutant\n{failure}")
                limit[room] = 30 + 3 * (time.monotonic() - begun)
            verdict = probe(mutant, tests[room], limit[room])
            counts[verdict] += 1
            if verdict == "survived":
                survivors.append({"room": room, **asdict(mutant)})
            if verdict != "uncompilable":
                print(f"{verdict}  {mutant}", flush=True)
    except KeyboardInterrupt:
        print("interrupted")
    finally:
        SURVIVORS.write_text(json.dumps(survivors, indent=1))
    print(f"{counts['killed'] + counts['survived']} mutants: {counts['killed']} killed, {counts['survived']} survived "
          f"({counts['uncompilable']} more did not compile)")


if __name__ == "__main__":
    main()
