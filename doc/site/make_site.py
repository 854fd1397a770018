"""Makes the site: the pages, a gallery, the API and the pendulum to start by mouse, as static HTML by FORD 6.

    make_site.py --top TOP --build BUILD --ford FORD --program KYVADLO --version X.Y.Z

FORD reads a module written here from the sources: every public procedure once, by its generic name, with its comment, the
arguments of double precision, its formula from doc/formulas.md or doc/elliptic.md, and a picture drawn from values of
the program. Formulas become MathML here, so that no other host is asked for anything.
"""
import argparse
import html
import math
import os
import pathlib
import re
import shutil
import subprocess

from latex2mathml.converter import convert

parser = argparse.ArgumentParser()
for name in ("top", "build", "ford", "program", "version"):
    parser.add_argument("--" + name, required=True)
options = parser.parse_args()
TOP, BUILD = pathlib.Path(options.top), pathlib.Path(options.build)
WORK, SITE = BUILD / "site_work", BUILD / "site"
formulas = []          # MathML, put into the pages of FORD at the end, since Markdown would spoil it


def mathematics(text):
    """Formulas of a text, outside of code, as marks that no Markdown touches."""
    def mark(formula, display):
        mathml = convert(formula.strip(), display="block" if display else "inline")
        formulas.append(mathml)
        return f"KYVFORMULA{len(formulas) - 1}END"
    parts = re.split(r"(^```.*?^```|`[^`\n]*`)", text, flags=re.S | re.M)
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r"\$\$(.+?)\$\$", lambda m: mark(m[1], True), parts[i], flags=re.S)
        parts[i] = re.sub(r"\$([^$]+?)\$", lambda m: mark(m[1], False), parts[i], flags=re.S)
    return "".join(parts)


# ---- Pages ----------------------------------------------------------------------------------------------------------

pages = {path.name: path.read_text() for path in sorted((TOP / "doc").glob("*.md"))}
page_folder = WORK / "pages"
shutil.rmtree(WORK, ignore_errors=True)
page_folder.mkdir(parents=True)
beside = WORK / "beside"          # what lies beside the pages
for name in ("pictures", "files", "media"):
    (beside / name).mkdir(parents=True)
gallery = []


def link(target, folder):
    """A link of a page in `folder` of the sources, as one of the site's pages has it."""
    target, mark, anchor = target.partition("#")
    if not target or re.match(r"[a-z]+:", target):
        return target + mark + anchor
    path = (folder / target).resolve()
    if path.suffix == ".md" and path.parent == TOP / "doc":
        return path.stem + ".html" + mark + anchor
    if path.name == "README.md":
        return "index.html" + mark + anchor
    if path.suffix in (".svg", ".png"):
        shutil.copy(path, beside / "pictures" / path.name)
        return "pictures/" + path.name
    if path.is_dir():
        return "files"
    shutil.copy(path, beside / "files" / path.name)
    return "files/" + path.name


def page_text(text, folder, name):
    """The Markdown of a page for FORD: title apart, links of the site, formulas marked."""
    title = re.match(r"# (.*)\n", text)[1]
    text = text[text.index("\n") + 1:]
    for alt, target in re.findall(r"!\[([^]]*)\]\(([^)]*)\)", text):
        gallery.append((alt, link(target, folder), name))
    parts = re.split(r"(^```.*?^```)", text, flags=re.S | re.M)
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r"\]\(([^)\s]*)\)", lambda m: "](" + link(m[1], folder) + ")", parts[i])
    return f"title: {title}\n\n" + mathematics("".join(parts))


ORDER = ["getting_started", "commands", "scene_format", "effects", "fitting", "building", "python", "integrator", "examples", "elliptic",
         "c_interface", "legacy_fortran", "recipes", "formulas", "hard_cases", "accuracy", "accuracy_tables", "speed"]
order = [name + ".md" for name in ORDER if name + ".md" in pages] + [name for name in pages if name[:-3] not in ORDER]
for name in order:
    (page_folder / name).write_text(page_text(pages[name], TOP / "doc", name))
readme = (TOP / "README.md").read_text()
front = page_text(readme, TOP, "README.md")
index = "title: Pages\n" + "".join(
    f"ordered_subpage: {name}\n" for name in ["pendulum.md"] + order + ["gallery.md"])
index += "\n" + "\n".join(f"* [{re.match('# (.*)', pages[name])[1]}]({name[:-3]}.html)" for name in order)
index += "\n* [A pendulum to start by mouse](pendulum.html)\n* [Gallery](gallery.html)\n"
(page_folder / "index.md").write_text(index)
seen = dict.fromkeys((target, alt, name) for alt, target, name in gallery if target.startswith("pictures/"))
(page_folder / "gallery.md").write_text("title: Gallery\n\n" + "\n\n".join(
    f"![{alt}]({target})\n\n{alt}: [{name}]({name[:-3] + '.html' if name != 'README.md' else 'index.html'})" for target, alt, name in seen))
shutil.copy(TOP / "doc/site/pendulum.js", beside / "media")
(page_folder / "pendulum.md").write_text((TOP / "doc/site/pendulum.md").read_text())

# ---- The API --------------------------------------------------------------------------------------------------------


def joined(path):
    """Lines of a source, its includes in place, continuations joined, and comments kept."""
    lines = []
    for line in path.read_text().split("\n"):
        include = re.match(r'#include "(.*)"', line)
        if include and (path.parent / include[1]).exists():
            lines += joined(path.parent / include[1])
        elif lines and lines[-1].partition("!")[0].rstrip().endswith("&") and not line.lstrip().startswith("!"):
            lines[-1] = lines[-1].partition("!")[0].rstrip()[:-1].rstrip() + " " + line.strip()
        else:
            lines.append(line)
    return lines


# (The orbits in double-double numbers bear the names of the public ones.)
sources = [path for folder in ("elliptic", "arithmetic", "pendulum") for path in sorted((TOP / "src" / folder).glob("*.[fF]90"))
           if not path.name.startswith("double_double")]
sources.append(TOP / "src/release.f90")
modules, uses, procedures, generics, types = {}, {}, {}, {}, {}
for path in sources:
    inside = None
    doc = []
    lines = joined(path)
    for number, line in enumerate(lines):
        text = line.strip()
        start = re.match(r"module (\w+)$", text)
        if start:
            inside = modules.setdefault(start[1], set())
            used = uses.setdefault(start[1], [])
        merged = re.match(r"use (\w+)(?:, only: (.*))?$", text)
        if merged and inside is not None:
            used.append((merged[1], merged[2] and re.split(r", *", merged[2])))
        if text.startswith("public ::") and inside is not None:
            inside.update(re.split(r"[ ,]+", text.partition("!")[0][9:].strip()))
        generic = re.match(r"interface (\w+)$", text)
        if generic:
            for following in lines[number + 1:]:
                specific = re.match(r"\s*module procedure (?:::)?\s*(.*)", following)
                if not specific:
                    break
                generics.setdefault(generic[1], []).extend(re.split(r"[ ,]+", specific[1].strip()))
        kind = re.match(r"(?!end|module procedure)(.*?)\b(function|subroutine) (\w+)\s*\((.*?)\)\s*(.*)", text)
        if kind and not text.startswith("!"):
            body = []
            for following in lines[number + 1:]:
                if re.match(r"\s*(!.*)?$", following) or re.match(r"\s*(import|use)\b", following):
                    if not following.strip():
                        break
                    continue
                if "::" not in following:
                    break
                body.append(following.strip())
            procedures.setdefault(kind[3], (kind[1], kind[2], kind[4], kind[5], doc, body))
        shape = re.match(r"type(?:,[^:]*)? ::\s*(\w+)$", text)
        if shape:
            components, bound = [], {}
            for following in lines[number + 1:]:
                if re.match(r"\s*end type", following):
                    break
                item = following.strip()
                if item.startswith(("procedure", "generic")):
                    if "private" not in item.partition("::")[0]:
                        # Of a generic name the first procedure is shown.
                        for word in item.partition("::")[2].split("," if "procedure" in item else "@"):
                            own, _, target = word.partition("=>")
                            bound.setdefault(own.strip(), target.split(",")[0].strip() or own.strip())
                elif "::" in item and "private" not in item.partition("::")[0] and not item.startswith("!"):
                    components.append(item)
            types.setdefault(shape[1], (doc, components, bound))
        doc = doc + [text[2:].strip()] if text.startswith("!>") else doc if text.startswith("!") else []

def names_of(module):
    """What a module exports: its own list, or those of the modules that it merges."""
    return modules.get(module) or {name for used, names in uses.get(module, ()) for name in names or names_of(used)}


public = {}            # Name in `use kyvadlo` -> name in the sources
for line in joined(TOP / "src/kyvadlo.F90"):
    use = re.match(r"\s*use (\w+)(?:, only: (.*))?$", line)
    for item in re.split(r",\s*", use[2]) if use and use[2] else sorted(names_of(use[1])) if use else ():
        name, _, original = item.partition("=>")
        if re.search(r"_real(32|64|128)$|_kind$", name.strip()):
            continue
        public.setdefault(name.strip(), (original or name).strip())

# Formulas by the procedure that they belong to.
formula_of = {}
for line in pages["formulas.md"].split("\n"):
    row = re.match(r"\| (\(.*?) \| (.*) \| (.*) in `src/", line)
    if row:
        for name in re.findall(r"`(\w+)`", row[3]):
            formula_of.setdefault(name, []).append(f"{row[1]} {row[2]}")
    row = re.match(r"\| (`\w+`[`\w, ]*) \| (.*\$.*) \|$", line)
    for name in re.findall(r"`(\w+)`", row[1]) if row else ():
        formula_of.setdefault(name, []).append(row[2])
for line in pages["elliptic.md"].split("\n"):
    row = re.match(r"\| (`.*?`) \| ([^|]*\$[^|]*) \| ([^|]*?) ?\|$", line)
    if row:
        for name in re.findall(r"`(\w+)\(", row[1]):
            formula_of.setdefault(name, []).append(row[2] + (f" ({row[3]})" if row[3] else ""))

# What a picture shows: request of eval with x in it, range of x.
PICTURES = {
    "elliptic_k": ("K x", -2, 0.999), "elliptic_e": ("E x", -2, 1), "elliptic_d": ("D x", -2, 0.999), "elliptic_b": ("B x", -2, 1),
    "elliptic_pi": ("Pi x 0.5", -3, 0.99), "elliptic_f": ("F x 0.8", -6, 6), "elliptic_einc": ("Einc x 0.8", -6, 6),
    "elliptic_dinc": ("Dinc x 0.8", -6, 6), "elliptic_binc": ("Binc x 0.8", -6, 6), "elliptic_piinc": ("Piinc 0.5 x 0.8", -6, 6),
    "elliptic_kc": ("Kc x", 0.001, 3), "elliptic_ec": ("Ec x", 0, 3), "elliptic_dc": ("Dc x", 0.001, 3), "elliptic_bc": ("Bc x", 0, 3),
    "elliptic_pic": ("Pic x 0.5", -3, 0.99), "elliptic_fc": ("Fc x 0.2", -6, 6), "elliptic_eincc": ("Eincc x 0.2", -6, 6),
    "elliptic_dincc": ("Dincc x 0.2", -6, 6), "elliptic_bincc": ("Bincc x 0.2", -6, 6), "elliptic_piincc": ("Piincc 0.5 x 0.2", -6, 6),
    "carlson_rc": ("rc 1 x", 0.01, 4), "carlson_rf": ("rf 0 x 1", 0.01, 4), "carlson_rd": ("rd 0 1 x", 0.1, 4),
    "carlson_rj": ("rj 0 1 2 x", 0.05, 4), "carlson_rg": ("rg 0 1 x", 0, 4),
    "elliptic_nome": ("nome x", -3, 1), "elliptic_nomec": ("nomec x", 0, 4), "jacobi_zeta": ("zeta x 0.9", -6, 6),
    "jacobi_zetac": ("zetac x 0.1", -6, 6), "heuman_lambda": ("heuman x 0.5", -3, 3), "heuman_lambdac": ("heumanc x 0.5", -3, 3),
    "jacobi_functions": ("jacobi x 0.9", -8, 8), "jacobi_functionsc": ("jacobic x 0.1", -8, 8),
    "theta_function": ("theta 1 x 0.3", -6, 6), "bulirsch_cel": ("cel x 1 1 1", 0.05, 3), "bulirsch_el1": ("el1 x 0.5", -6, 6),
    "bulirsch_el2": ("el2 x 0.5 1 0.25", -6, 6), "bulirsch_el3": ("el3 x 0.5 0.5", -6, 6),
    "height": ("position 1 9.80665 0.3 -0.8 x@2", 0, 3),
    "azimuth": ("azimuth 1 9.80665 0.3 -0.8 x", 0, 3), "period": ("orbit 1 9.80665 x -0.95@0", -0.94, 0.94),
    "modulus": ("orbit 1 9.80665 x -0.95@1", -0.94, 0.94), "complementary_modulus": ("orbit 1 9.80665 x -0.95@2", -0.94, 0.94),
    "quarter_period": ("orbit 1 9.80665 x -0.95@3", -0.94, 0.94), "nome": ("orbit 1 9.80665 x -0.95@4", -0.94, 0.94),
    "azimuth_rate": ("orbit 1 9.80665 x -0.95@5", -0.94, 0.94), "azimuth_per_period": ("orbit 1 9.80665 x -0.95@6", -0.94, 0.94),
    "apsidal_advance": ("orbit 1 9.80665 x -0.95@7", -0.94, 0.94), "orbit_period_from_gaps": ("orbit_gaps 1 9.80665 x 0.05@0", 0.06, 1.9),
    "jacobi_am": ("jacobi x 0.9@3", -8, 8), "jacobi_amc": ("jacobic x 0.1@3", -8, 8),
    "jacobi_evaluate": ("jacobi x 0.9", -8, 8), "time_to_height": ("passage_height 1 9.80665 0.3 -0.8 x", -0.8, 0.3),
    "time_to_azimuth": ("passage_azimuth 1 9.80665 0.3 -0.8 x", 0, 12), "orbits_period_from_gaps": ("orbit_gaps 1 9.80665 x 0.05@0", 0.06, 1.9),
    "orbits_advance_from_gaps": ("orbit_gaps 1 9.80665 x 0.05@7", 0.06, 1.9),
    "orbits_constants_from_gaps": ("orbit_gaps 1 9.80665 x 0.05@4", 0.06, 1.9),
    "orbits_locate_from_gaps": ("position_gaps 1 9.80665 x 0.05 1@0", 0.06, 1.9),
    "vertical_speed": ("position 1 9.80665 0.3 -0.8 x@5", 0, 3), "locate": ("position 1 9.80665 0.3 -0.8 x@0", 0, 3),
    # What a set-up makes: the period over one of its numbers, or the height in time.
    "new_orbit_from_heights": ("orbit 1 9.80665 x -0.95@0", -0.94, 0.94), "new_orbit_from_gaps": ("orbit_gaps 1 9.80665 x 0.05@0", 0.06, 1.9),
    "new_orbit_from_rises": ("orbit_rises 1 9.80665 x 0.05@0", 0.06, 1.9),
    "new_orbit_from_release": ("orbit_release 1 9.80665 x 1@0", 1, 179),
    "new_orbit_from_state": ("state 1 9.80665 0.6 0 -0.8 0.3 1.2 0.225 x@2", 0, 3)}


RATIO = re.compile(r"jacobi_([scdn])([scdn])(c?)$")


def picture(name):
    """A curve as SVG in the text of a page."""
    ratio = RATIO.match(name)
    if ratio:
        return curve_of("jacobic x 0.1" if ratio[3] else "jacobi x 0.9", -8, 8, f"{ratio[1]}{ratio[2]}")
    return curve_of(*PICTURES[name]) if name in PICTURES else ""


def value(answer, column, ratio):
    numbers = [float(word) for word in answer.split()]
    if not ratio:
        return numbers[column]
    parts = dict(zip("scd", numbers), n=1.0)
    return parts[ratio[0]] / parts[ratio[1]] if abs(parts[ratio[1]]) > 0.05 else math.nan


def curve_of(request, first, last, ratio=None):
    request, _, column = request.partition("@")
    shown = request + (f", {ratio}" if ratio else "")
    xs = [first + (last - first) * i / 200 for i in range(201)]
    answers = subprocess.run([options.program, "eval"], input="".join(re.sub(r"\bx\b", repr(x), request) + "\n" for x in xs),
                             capture_output=True, text=True).stdout.split("\n")
    curve = [(x, value(answer, int(column or 0), ratio)) for x, answer in zip(xs, answers) if answer and "error" not in answer and "Inf" not in answer]
    low, high = min(y for _, y in curve if y == y), max(y for _, y in curve if y == y)
    pieces, points = [], ""            # a pole parts the curve
    for x, y in curve + [(last, math.nan)]:
        if y == y:
            points += f" {40 + 320 * (x - first) / (last - first):.1f},{170 - 150 * (y - low) / ((high - low) or 1):.1f}"
        elif points:
            pieces.append(f'<polyline points="{points.strip()}" fill="none" stroke="#2a6fb0"/>')
            points = ""
    return (f'<svg class="curve" width="380" height="200" role="img" aria-label="{html.escape(request)} over x">'
            f'<rect x="40" y="20" width="320" height="150" fill="none" stroke="#999"/>'
            f'{"".join(pieces)}'
            f'<text x="40" y="186" font-size="11">x = {first:g}</text><text x="360" y="186" font-size="11" text-anchor="end">{last:g}</text>'
            f'<text x="44" y="32" font-size="11">{high:.4g}</text><text x="44" y="166" font-size="11">{low:.4g}</text>'
            f'<text x="200" y="14" font-size="12" text-anchor="middle">kyvadlo eval {html.escape(shown)}</text></svg>')


def clean(text):
    """Of the kind of double precision, without names of templates."""
    return re.sub(r"\b(wp|cp)\b", "real64", re.sub(r"_kind\b|_real64\b|_name\b", "", text)).replace("real(real64)", "real(real64)")


def comment(lines):
    return [f"!> {line}" if line else "!>" for line in lines]


def shared_words(name, said, body, of_type):
    """Domain and error where they are the same for a family, and its sources say them once."""
    words = []
    if name.endswith("c") and name[:-1] in public and "domain" not in said:
        words += ["", f"Domain, error and source as [[{name[:-1]}]], of m = 1 - mc."]
    if name.startswith("neville_"):
        words += ["", "Domain and source as [[jacobi_functions]]; so is the error of the ratios."]
    if re.match("new_(orbit|derivatives|string_motion)", name):
        words += ["", "Domain: length and gravity positive and finite, and a start that is one."]
    if any("error_type" in line for line in body):
        words += ["", "Error: `error` is allocated with a code and a sentence that names the rule and the values; what was to be set up",
                  "answers NaN then."]
    elif of_type:
        words += [""] + ["Domain: what is set up; NaN else."]*("domain" not in said) \
            + ["Errors: [Accuracy](../page/accuracy.html)."]*("error" not in said)
    return words


def stub(name, specific, of_type=None):
    """A procedure with its comment and arguments, and nothing in it."""
    attributes, kind, arguments, result, doc, body = procedures[specific]
    text = [clean(line) for line in doc]
    if RATIO.match(name) or name.startswith("jacobi_am"):
        text += ["", "Domain, error and source as [[jacobi_functions]]; Infinity at a pole."]
    text += shared_words(name, " ".join(text).lower(), body, of_type)
    if formula_of.get(name) or formula_of.get(specific):
        text += ["", "**Formula.** " + mathematics("; ".join(formula_of.get(name) or formula_of.get(specific)))]
    drawn = picture(name)
    if drawn:
        formulas.append(drawn)
        text += ["", f"KYVFORMULA{len(formulas) - 1}END"]
    if of_type:
        text += ["", f"Bound to `{of_type}`: the first argument stands before the %."]
    attributes = re.sub(r"\bmodule\b|\bimpure\b", "", clean(attributes)).strip()
    result = re.sub(r"bind\(.*?\)", "", clean(result))
    return comment(text) + [f"{attributes} {kind} {name}({clean(arguments)}) {result}".strip()] + \
        [clean(line) for line in body] + [f"end {kind} {name}", ""]


def find(name):
    original = public.get(name, name)
    for candidate in generics.get(original, []) + [original + "_kind", original + "_real64", original + "_name", original]:
        if candidate in procedures:
            return candidate


shown_types = sorted((name for name in public if public[name] in types and not re.search(r"_real(32|64|128)$", name)),
                     key=lambda name: (name != "orbit_type", name))
module = [f"!> What `use kyvadlo` gives: every procedure by its generic name, here with the arguments of double precision (where there are",
          "!> single and quadruple ones, the same names take them). What belongs to an orbit is bound to its type: `orbit%period()`.",
          "module kyvadlo", "implicit none", "private", ""]
contained, done, without = [], set(), []
for name in shown_types:
    doc, components, bound = types[public[name]]
    doc = re.sub(r" Components below `motion` are .*", "", " ".join(doc))
    module += comment([clean(doc)]) + [f"type, public :: {name}"]
    # Of an orbit what is below `motion` is the evaluation's; so is all of other set-ups, and what has no public type.
    if name in ("jacobi_type", "derivatives_type"):
        components = []
    if name == "orbit_type":
        components = components[:1 + next(i for i, line in enumerate(components) if re.search(r":: motion\b", line))]
    components = [line for line in components if "mark" not in line.partition("=")[0]
                  and all(used in public.values() for used in re.findall(r"type\((\w+)\)", line))]
    for shown in shown_types:
        components = [line.replace(f"type({public[shown]})", f"type({shown})") for line in components]
    module += [clean(line) for line in components] or ["integer :: hidden"]
    implementations = []
    for item, target in bound.items():
        specific = find(target)
        if not specific:
            continue
        own = item if item not in done else name.replace("_type", "_") + item
        implementations.append(f"procedure :: {item}" + ("" if own == item else f" => {own}"))
        if own not in done:
            done.add(own)
            contained += stub(own, specific, name)
    module += (["contains"] + implementations if implementations else []) + [f"end type {name}", ""]
for name in public:
    if name in done or name in shown_types or re.search(r"_real(32|64|128)$", name):
        continue
    specific = find(name)
    if specific:
        done.add(name)
        contained += stub(name, specific)
    else:
        without.append(name)
lost = [name for name in without if not re.match(r"(code|motion|start|event|accuracy)_|kyvadlo_(version_number|error_type)$", name)]
if lost:
    raise SystemExit(f"public, and not found in the sources: {lost}")
listed = sorted(done)
module += ["public :: " + ", &\n   ".join(listed), "", "contains", ""] + contained + ["end module kyvadlo"]
api = WORK / "api"
api.mkdir()
(api / "kyvadlo.f90").write_text("\n".join(module) + "\n")
print(f"{len(done)} procedures, {len(shown_types)} types; constants and such, not shown: {', '.join(without)}")

# ---- FORD -----------------------------------------------------------------------------------------------------------

(WORK / "site.md").write_text(f"""project: kyvadlo
summary: The spherical pendulum in closed form, and the elliptic functions it needs
version: {options.version}
author: the kyvadlo authors
license: MIT
src_dir: {api}
output_dir: {SITE}
page_dir: {page_folder}
extensions: f90
predocmark: >
docmark: !
display: public
graph: false
search: true
source: false
incl_src: false
preprocess: false

{front.partition(chr(10) * 2)[2]}
""")
shutil.rmtree(SITE, ignore_errors=True)
run = subprocess.run([options.ford, str(WORK / "site.md")], capture_output=True, text=True, cwd=WORK)
output = run.stdout + run.stderr
if run.returncode or re.search(r"[Ww]arning|[Ee]rror:|Traceback", output):
    raise SystemExit(output)

shutil.copytree(beside, SITE / "page", dirs_exist_ok=True)
STYLE = """<style>math{font-size:105%} .curve{max-width:100%} img{max-width:100%} table{margin:1em 0} td,th{padding:2px 8px;border-bottom:1px solid #ddd}</style>"""
for path in list(SITE.rglob("*.html")) + list(SITE.rglob("tipuesearch_content.js")):
    text = path.read_text()
    is_page = path.suffix == ".html"
    # In the front page links lead into the folder of pages.
    if path == SITE / "index.html":
        text = re.sub(r'(href|src)="((?:%s)\.html|pictures/|files/)' % "|".join(name[:-3] for name in pages), r'\1="page/\2', text)
    text = re.sub(r"KYVFORMULA(\d+)END", lambda m: formulas[int(m[1])] if is_page else " ", text)
    if is_page:
        text = re.sub(r"<!--\[if.*?endif\]-->", "", text, flags=re.S)
        text = re.sub(r"<script[^>]*\bsrc=\"(https?:)?//[^>]*></script>|<script type=\"text/x-mathjax-config\">.*?</script>", "", text, flags=re.S)
        text = re.sub(r'<li id="statements">.*?</li>|<li id="source-file">.*?</li>', "", text, flags=re.S)
        text = text.replace("</head>", STYLE + "</head>", 1)
    path.write_text(text)
print(f"the site begins at {SITE / 'index.html'}")
