#!/usr/bin/env python3
"""Proves that a change of the code changed no picture, number or id: draws seeded settings and keeps hashes.

    scripts/fingerprint.py -o before.json                       # of build/release/gbufferlab
    scripts/fingerprint.py --against before.json                # exit 1 and a list if anything differs
    scripts/fingerprint.py --program OTHER -n 40 --against before.json   # the first 40 settings alone

Kept are: the pixels of every view (decoded and raw) and the counts of each setting, or its exit code and the id of the
problem where it is refused; `list WHAT --json` without its texts (label, help, cost, source, ...); bench counts and
errors of every preset. Times are left out. Run by hand; needs python3.
"""
import argparse
import hashlib
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import zlib
from concurrent.futures import ThreadPoolExecutor

LISTS = "presets scenes layouts encodings positions methods mistakes culls views overlays options keys lessons studies".split()
TEXTS = {"label", "help", "cost", "source", "reason", "title"}
SIZE = "96x54"


def run(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, stdin=subprocess.DEVNULL)


def without_texts(node):
    if isinstance(node, dict):
        return {k: without_texts(v) for k, v in node.items() if k not in TEXTS}
    return [without_texts(v) for v in node] if isinstance(node, list) else node


def digest(data):
    if not isinstance(data, bytes):
        data = json.dumps(data, sort_keys=True).encode()
    return hashlib.sha256(data).hexdigest()[:16]


def pixels(path):
    """The decompressed rows of a PNG: neither its texts nor how well it was packed."""
    data, at, packed = open(path, "rb").read(), 8, b""
    while at < len(data):
        length, kind = int.from_bytes(data[at:at + 4], "big"), data[at + 4:at + 8]
        if kind in (b"IHDR", b"IDAT"):
            packed += data[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    return digest(zlib.decompress(packed))


def refusal(result):
    ids = re.findall(r"\[([a-z0-9-]+)\]\s*$", result.stderr.strip())
    return {"exit": result.returncode, "problem": ids[-1] if ids else None}


def counts(report):
    # A reason is a text; a time is never the same twice.
    return {k: v for k, v in report.items()
            if not k.startswith("time_") and k not in ("method_reason", "choices", "driver", "device", "frames")}


def seeded_settings(program, n):
    options = json.loads(run(program, "list", "options", "--json").stdout)
    presets = [p["id"] for p in json.loads(run(program, "list", "presets", "--json").stdout)]
    scenes = [s["id"] for s in json.loads(run(program, "list", "scenes", "--json").stdout)]
    mistakes = [m["id"] for m in json.loads(run(program, "list", "mistakes", "--json").stdout)]
    # By path and id alone, sorted, so that a new order of rows draws the same settings.
    choices = sorted((o["id"], sorted(o["values"])) for o in options
                     if o.get("values") and not o["id"].startswith("view.") and o["id"] not in ("lights.source",))
    dice, out = random.Random(20261128), []
    for i in range(n):
        arguments = ["--preset", presets[i % len(presets)], "--size", SIZE]
        if i >= len(presets):
            arguments += ["--scene", "builtin:" + dice.choice(scenes)]
            for path, values in dice.sample(choices, dice.randint(1, 5)):
                arguments += ["--set", f"{path}={dice.choice(values)}"]
            if dice.random() < 0.4:
                arguments += ["--lights", str(dice.choice([0, 1, 3, 16, 64, 200]))]
            if dice.random() < 0.3:
                arguments += ["--time", str(dice.choice([0.5, 3, 11])), "--seed", str(dice.randint(2, 9))]
            if dice.random() < 0.25:
                arguments += ["--set", f'mistakes=["{dice.choice(mistakes)}"]']
            if dice.random() < 0.2:
                arguments += ["--without", dice.choice(["compute", "clip-control", "depth-clamp"])]
        out.append(arguments)
    return out


def drawn(program, arguments):
    folder = tempfile.mkdtemp(prefix="gbl-fingerprint-")
    try:
        result = run(program, "render", *arguments, "--raw", "--json", "-o", folder)
        if result.returncode != 0:
            return refusal(result)
        report = json.loads(result.stdout)
        report.pop("files", None)
        truth = run(program, "render", *arguments, "--only", "reference,error", "-o", folder)
        names = sorted(f for f in os.listdir(folder) if f.endswith(".png"))
        return {"counts": counts(report), "truth_exit": truth.returncode,
                "views": {f: pixels(os.path.join(folder, f)) for f in names}}
    finally:
        shutil.rmtree(folder)


def benched(program, preset):
    result = run(program, "bench", "--preset", preset, "--size", SIZE, "--json")
    return counts(json.loads(result.stdout)) if result.returncode == 0 else refusal(result)


def fingerprint(program, n):
    out = {"lists": {w: digest(without_texts(json.loads(run(program, "list", w, "--json").stdout))) for w in LISTS}}
    cases = seeded_settings(program, n)
    presets = sorted({c[1] for c in cases})
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        out["settings"] = dict(zip((" ".join(c) for c in cases), pool.map(lambda c: drawn(program, c), cases)))
        out["bench"] = dict(zip(presets, pool.map(lambda p: benched(program, p), presets)))
    return out


def differences(before, after, where=""):
    if isinstance(before, dict) and isinstance(after, dict):
        for key in sorted(set(before) | set(after)):
            if key not in before or key not in after:
                yield f"{where} {key}: only {'after' if key in after else 'before'}"
            else:
                yield from differences(before[key], after[key], f"{where} {key}")
    elif before != after:
        yield f"{where}: {json.dumps(before)[:100]} -> {json.dumps(after)[:100]}"


def main():
    root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=os.path.join(root, "build/release/gbufferlab"))
    parser.add_argument("-n", type=int, default=200, help="how many settings (default 200)")
    parser.add_argument("-o", help="write the fingerprint here")
    parser.add_argument("--against", help="compare with this one")
    a = parser.parse_args()
    now = fingerprint(a.program, a.n)
    if a.o:
        with open(a.o, "w") as f:
            json.dump(now, f, indent=1)
    refused = sum("exit" in v for v in now["settings"].values())
    views = sum(len(v.get("views", {})) for v in now["settings"].values())
    print(f"{len(now['settings'])} settings ({refused} refused), {views} pictures, {len(now['bench'])} rows of bench")
    if not a.against:
        return 0
    before = json.load(open(a.against))
    if len(now["settings"]) < len(before["settings"]):
        for part in ("settings", "bench"):
            before[part] = {k: v for k, v in before[part].items() if k in now[part]}
    found = list(differences(before, now))
    print("\n".join(found) or "nothing differs")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
