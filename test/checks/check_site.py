"""The site: nothing of another host, no dead link, no internal name, every procedure once; the search box answers from the file
system; the picture's positions are those of the program to 1e-12 of the length; no browser error.

    check_site.py SITE PROGRAM [CHROMIUM]
"""
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import urllib.parse

site, program = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
chromium = sys.argv[3] if len(sys.argv) > 3 else None
bad = []
pages = list(site.rglob("*.html"))
for page in pages:
    text = page.read_text()
    for tag, target in re.findall(r"<(\w+)[^>]*?\b(?:src|href)=[\"']([^\"']*)[\"']", text):
        if re.match(r"(https?:)?//", target):
            if tag != "a":
                bad.append(f"{page}: of another host: {target}")
        elif not re.match(r"(#|javascript:|mailto:|data:)", target) and target:
            path = page.parent / urllib.parse.unquote(target.partition("#")[0].partition("?")[0])
            if not path.exists():
                bad.append(f"{page.relative_to(site)}: a link to {target}, which is not there")
    if "KYVFORMULA" in text or re.search(r"\b\w+(_real64|_kind)\b", re.sub(r"<[^>]*>", "", text)) and page.parent.name in ("proc", "module", "type"):
        bad.append(f"{page}: an internal name")
for style in site.rglob("*.css"):
    if re.search(r"url\([\"']?(https?:)?//|@import [\"']?http", style.read_text(errors="replace")):
        bad.append(f"{style}: of another host")
procedures = [path.stem for path in (site / "proc").glob("*.html")]
for name in ("carlson_rf", "elliptic_pi", "jacobi_functions", "new_orbit_from_heights", "period", "locate", "kyvadlo_version_linked"):
    if procedures.count(name) != 1:
        bad.append(f"{name} stands {procedures.count(name)} times among the procedures")
if "<math" not in (site / "proc/elliptic_k.html").read_text() or "polyline" not in (site / "proc/elliptic_k.html").read_text():
    bad.append("elliptic_k shows no formula or no picture")


# What computes a number has its formula; what makes or asks an orbit need not.
without = [name for name in procedures if "Formula." not in (site / "proc" / f"{name}.html").read_text()
           and not re.match(r"(new_|neville|of_|is_|take_|kyvadlo_).*|.*(_text|time_limit|from_upper_turning|polar_angle_terms|starts_in_flight|locate|"
                             r"locate_at_real128|period|period_real128|_count|evaluate)$", name)]
if without:
    bad.append(f"no formula: {without}")
# Every one says where it is defined and how far off it may be, but those that answer in words, counts or truth.
for name in procedures:
    if not re.match(r"is_|kyvadlo_|.*(_text|_count|starts_in_flight)$", name):
        said = re.sub(r"<[^>]*>", " ", (site / "proc" / f"{name}.html").read_text().partition("</nav>")[2]).lower()
        bad += [f"{name} says nothing of its {word}" for word in ("domain", "error") if word not in said]
# The orbit's are those of the public type, with nothing of the evaluation.
for name in ("height", "azimuth", "locate", "azimuth_rate", "time_to_height", "evaluate", "of_period"):
    if procedures.count(name) != 1:
        bad.append(f"{name}, which is bound to a type, stands {procedures.count(name)} times among the procedures")
for page in list((site / "type").glob("*.html")) + list((site / "proc").glob("*.html")):
    inner = re.findall(r"type\((\w*(?:pair|batch|gaps|harmonics|kernel)\w*)\)|\b(start_phase|length_power|series_nome)\b", page.read_text())
    if inner:
        bad.append(f"{page.relative_to(site)} shows what is inside: {inner[0]}")


def browse(address):
    """The page as the browser shows it, and what its console says."""
    with tempfile.TemporaryDirectory() as profile:
        run = subprocess.run([chromium, "--headless=new", "--no-sandbox", "--disable-gpu", "--user-data-dir=" + profile,
                              "--host-resolver-rules=MAP * ~NOTFOUND", "--enable-logging=stderr", "--virtual-time-budget=4000", "--dump-dom", address],
                             capture_output=True, text=True, timeout=120)
    return run.stdout, [line for line in run.stderr.split("\n") if ":CONSOLE" in line]


if chromium:
    for name in ("index.html", "page/pendulum.html", "page/formulas.html", "proc/elliptic_k.html"):
        shown, console = browse((site / name).as_uri())
        if console or "</html>" not in shown:
            bad.append(f"{name}: the browser says {console}")
    if "from one highest point to the next" not in browse((site / "page/pendulum.html").as_uri())[0]:
        bad.append("the pendulum does not move")
    shown, console = browse((site / "search.html").as_uri() + "?q=carlson")
    if console or "carlson_rf.html" not in shown:
        bad.append(f"the search box does not find carlson: {console}")
    # Random orbits by their turning heights, and random states, at random times; the program is the judge.
    random.seed(1953)
    requests, calls = [], []
    while len(calls) < 500:
        z2, top = random.uniform(-1, -0.1), random.random()
        z1, t = z2 + top * (-2 * z2) * 0.98, random.uniform(0, 100)
        if z1 < 0.999:
            requests.append(f"position 1 9.80665 {z1!r} {z2!r} {t!r}")
            calls.append(["heights", z1, z2, t])
    while len(calls) < 1000:
        place = [random.gauss(0, 1) for _ in range(3)]
        size = sum(x * x for x in place) ** 0.5
        place = [x / size for x in place]
        push = [random.uniform(-2, 2) for _ in range(3)]
        along = sum(x * y for x, y in zip(place, push))
        velocity = [y - along * x for x, y in zip(place, push)]
        t = random.uniform(0, 20)
        requests.append("state 1 9.80665 " + " ".join(map(repr, place + velocity + [t])))
        calls.append(["state", place, velocity, t])
    answers = subprocess.run([program, "eval"], input="\n".join(requests) + "\n", capture_output=True, text=True).stdout.split("\n")
    expected = [[float(x) for x in answer.split()[:3]] for answer in answers if answer]
    with tempfile.TemporaryDirectory() as folder:
        check = pathlib.Path(folder) / "check.html"
        check.write_text(f"""<html><body><script>{(site / "page/media/pendulum.js").read_text()}</script><script>
const calls = {json.dumps(calls)}, expected = {json.dumps(expected)};
let worst = 0;
for (let i = 0; i < calls.length; i++) {{
  const c = calls[i], orbit = c[0] === "state" ? orbitFromState(1, 9.80665, c[1], c[2]) : orbitFromHeights(1, 9.80665, c[1], c[2]);
  locate(orbit, c[3]).forEach((x, k) => {{ const error = Math.abs(x - expected[i][k]); if (!(error <= worst)) worst = error; }});
}}
document.body.textContent = "positions " + calls.length + " worst " + worst;
</script></body></html>""")
        shown, console = browse(check.as_uri())
    found = re.search(r"positions (\d+) worst ([-+.\de]+|NaN)", shown)
    if not found or console or len(expected) != 1000 or not float(found[2]) <= 1e-12:
        bad.append(f"the positions of the picture: {found and found[0]}, {console}, {len(expected)} expected")
    else:
        print(f"{found[1]} positions of the picture, the worst {found[2]} l off")
print("\n".join(bad))
print(f"{len(pages)} pages, {len(procedures)} procedures" + ("" if chromium else "; no chromium here: not looked at in a browser"))
sys.exit(1 if bad else 0)
