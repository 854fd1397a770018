"""One orbit through ctypes, printed as CSV and drawn, seen from above.

    python3 orbit.py [LIBRARY [PICTURE]]

LIBRARY is the shared libkyvadlo_c (default: the one the system finds), PICTURE an SVG file to draw into. Nothing is compiled,
and nothing but Python's own modules is needed.
"""
import ctypes
import ctypes.util
import math
import sys

GRAVITY = 9.80665
PERIODS, ROWS = 9, 80


def load(path):
    library = ctypes.CDLL(path)
    pointer = ctypes.POINTER(ctypes.c_double)
    library.kyvadlo_orbit_bytes.argtypes = []
    library.kyvadlo_orbit_bytes.restype = ctypes.c_size_t
    library.kyvadlo_orbit_from_heights.argtypes = [ctypes.c_double]*4 + [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_size_t]
    library.kyvadlo_orbit_from_heights.restype = ctypes.c_int
    library.kyvadlo_height_period.argtypes = [ctypes.c_void_p]
    library.kyvadlo_height_period.restype = ctypes.c_double
    library.kyvadlo_locate_many.argtypes = [ctypes.c_void_p, ctypes.c_size_t, pointer, pointer, pointer]
    library.kyvadlo_locate_many.restype = None
    return library


def new_orbit(library, length, gravity, upper, lower):
    """The bytes of an orbit: they belong to Python, and may be copied and dropped like any others."""
    orbit = (ctypes.c_double*(library.kyvadlo_orbit_bytes()//8))()
    message = ctypes.create_string_buffer(300)
    if library.kyvadlo_orbit_from_heights(length, gravity, upper, lower, orbit, message, len(message)) != 0:
        raise ValueError(message.value.decode())
    return orbit


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else ctypes.util.find_library("kyvadlo_c")
    if path is None:
        sys.exit("orbit.py: no shared libkyvadlo_c found; name it: orbit.py path/to/libkyvadlo_c.so")
    library = load(path)
    orbit = new_orbit(library, 1.0, GRAVITY, 0.3, -0.8)
    period = library.kyvadlo_height_period(orbit)

    count = PERIODS*ROWS + 1
    times = (ctypes.c_double*count)(*(period*i/ROWS for i in range(count)))
    places = (ctypes.c_double*(3*count))()
    speeds = (ctypes.c_double*(3*count))()
    library.kyvadlo_locate_many(orbit, count, times, places, speeds)

    print("t,x,y,z,vx,vy,vz")
    for i in range(count):
        print(*(repr(x) for x in [times[i], *places[3*i:3*i + 3], *speeds[3*i:3*i + 3]]), sep=",")

    try:
        new_orbit(library, 1.0, GRAVITY, 0.8, 0.3)
    except ValueError as error:
        print("refused:", error, file=sys.stderr)
    else:
        sys.exit("orbit.py: an impossible orbit was accepted")

    if len(sys.argv) > 2:
        with open(sys.argv[2], "w", encoding="ascii") as picture:
            picture.write(drawing(places[0::3], places[1::3]))


def drawing(x, y):
    """The path seen from above (x to the right, y up the page) between the circles of the turning heights, as SVG."""
    radii = [math.hypot(a, b) for a, b in zip(x, y)]
    circles = "".join(f'<circle r="{r:.4f}"/>' for r in (min(radii), max(radii)))
    path = " ".join(f"{a:.4f},{-b:.4f}" for a, b in zip(x, y))
    return ('<svg xmlns="http://www.w3.org/2000/svg" width="480" height="480" viewBox="-1.05 -1.05 2.1 2.1" fill="none">'
            '<rect x="-1.05" y="-1.05" width="2.1" height="2.1" fill="white"/>'
            f'<g stroke="silver" stroke-width="0.006">{circles}</g>'
            f'<polyline stroke="black" stroke-width="0.008" points="{path}"/></svg>\n')


if __name__ == "__main__":
    main()
