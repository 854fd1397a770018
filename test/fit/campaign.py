#!/usr/bin/env python3
"""Many synthetic sets of every case, fitted from no guess: how many end in the right minimum, and whether the sigmas are true.

    campaign.py KYVADLO SETS [CASE...] [--extra]

A minimum is right where no pull is beyond 6 (case 5: but for the mirror image in y, which its pictures show alike). --extra frees
one parameter more, which must be named in `undetermined`."""
import json
import subprocess
import sys
import tempfile
import time

import numpy as np

from make_sets import make


def pulls_of(answer, truth):
    names, pulls = [], []
    for name, true in truth.items():
        got = answer['parameters'][name]
        value, sigma, true = np.atleast_1d(got['value']), got['sigma'], np.atleast_1d(true)
        if sigma is None:
            return None, None
        for i, (v, s, t) in enumerate(zip(value, np.atleast_1d(sigma), true)):
            names.append(name + (str(i + 1) if len(value) > 1 else ''))
            pulls.append(np.nan if s is None else (v - t) / max(s, 1e-300))
    return names, np.array(pulls)


def mirrored(truth):
    other = json.loads(json.dumps(truth))
    for name in ('position', 'velocity'):
        other[name][1] *= -1
    return other


def run(program, case, sets, extra):
    wrong, seconds, all_pulls, names = [], [], [], None
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(1, sets + 1):
            name = make(case, seed, folder, extra)
            with open(f'{folder}/{name}.truth') as f:
                about = json.load(f)
            begin = time.time()
            done = subprocess.run([program, 'fit', f'{folder}/{name}.nml', f'{folder}/{name}.csv', '--format', 'json'],
                                  capture_output=True, text=True)
            seconds.append(time.time() - begin)
            if done.returncode != 0:
                wrong.append((seed, f'status {done.returncode} {done.stderr.strip()}'))
                continue
            answer = json.loads(done.stdout)
            if extra:
                named = any(about['extra'] in word.split('/') for word in answer['undetermined'])
                if not named or answer['parameters'][about['extra']]['sigma'] is not None:
                    wrong.append((seed, f"undetermined {answer['undetermined']}"))
                continue
            names, pulls = pulls_of(answer, about['truth'])
            if case == 5 and pulls is not None and not np.max(np.abs(pulls)) < 6:
                names, pulls = pulls_of(answer, mirrored(about['truth']))
            if pulls is None or not np.max(np.abs(pulls)) < 6:
                wrong.append((seed, f"chi2/dof {answer['chi2'] / answer['dof']:.3g}, undetermined {answer['undetermined']}, pulls "
                              f"{None if pulls is None else np.round(pulls, 1)}"))
                continue
            all_pulls.append(pulls)
    print(f'case {case}{" and one more" if extra else ""}: {sets - len(wrong)} of {sets} right; '
          f'{np.median(seconds):.3f} s the median, {max(seconds):.3f} s the longest')
    if all_pulls:
        table = np.array(all_pulls)
        for i, name in enumerate(names):
            print(f'   {name:12s} pull {np.nanmean(table[:, i]):+.3f} +- {np.nanstd(table[:, i], ddof=1):.3f}')
    for seed, why in wrong[:20]:
        print(f'   set {seed}: {why}')
    return len(wrong)


if __name__ == '__main__':
    words = [w for w in sys.argv[1:] if w != '--extra']
    cases = [int(w) for w in words[2:]] or [1, 2, 3, 4, 5]
    sys.exit(min(1, sum([run(words[0], case, int(words[1]), '--extra' in sys.argv) for case in cases])))
