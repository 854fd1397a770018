// The spherical pendulum by its closed form, and a picture of it to start by mouse. Numbers in brackets are those of formulas.md.
"use strict";

// The arithmetic-geometric mean.
function agm(a, b) {
  for (let i = 0; i < 40 && Math.abs(a - b) > 1e-16 * a; i++) [a, b] = [(a + b) / 2, Math.sqrt(a * b)];
  return a;
}

// Carlson's integral of the first kind, by duplication.
function carlsonRF(x, y, z) {
  let mean = (x + y + z) / 3;
  for (let i = 0; i < 60 && Math.max(Math.abs(mean - x), Math.abs(mean - y), Math.abs(mean - z)) > 2e-3 * mean; i++) {
    const lambda = Math.sqrt(x * y) + Math.sqrt(y * z) + Math.sqrt(z * x);
    [x, y, z] = [(x + lambda) / 4, (y + lambda) / 4, (z + lambda) / 4];
    mean = (x + y + z) / 3;
  }
  const X = 1 - x / mean, Y = 1 - y / mean, Z = -X - Y, e2 = X * Y - Z * Z, e3 = X * Y * Z;
  return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44 - 5 * e2 ** 3 / 208 + 3 * e3 * e3 / 104) / Math.sqrt(mean);
}

// An orbit from its gaps: d = l+z and h = l-z at the upper (1) and lower (2) turning height, e3 = z3-l, s = -(z1+z2), D = z1-z2.
function orbitFromGaps(l, g, { d1, d2, h1, h2, e3, s, D }) {
  const d3 = e3 + 2 * l, z31 = e3 + h1, z32 = e3 + h2;
  const M = agm(Math.sqrt(z32), Math.sqrt(z31)), K = Math.PI * Math.sqrt(z32) / (2 * M);
  const q = Math.exp(-Math.PI * agm(1, Math.sqrt(z31 / z32)) / agm(1, Math.sqrt(D / z32)));       // (33)
  const orbit = { l, g, K, q, T: Math.PI * l * Math.SQRT2 / (Math.sqrt(g) * M), kk: z31 / z32, D };  // (16)
  const place = (sn2, cn2, dn2) => Math.PI / (2 * K) * Math.sqrt(sn2) * carlsonRF(cn2, dn2, 1);      // [S6.2]
  const b = orbit.b = place(e3 / z31, h1 / z31, h2 / z32), b1 = orbit.b1 = place(d2 / d1, D / d1, D * d3 / (z32 * d1));
  let sum = Math.tanh(b);                                                                          // [S5.2]
  for (let n = 1, p = q; n < 400 && p * Math.exp(2 * Math.max(b, b1)) > 1e-18; n++, p *= q) {
    const sinh = Math.sinh(2 * (n % 2 ? b1 : b)), cosh = Math.cosh(2 * (n % 2 ? b1 : b));
    sum += 4 * p * sinh / (1 + (n % 2 ? -2 : 2) * p * cosh + p * p);
  }
  orbit.lambda = Math.PI * sum / orbit.T;
  orbit.scaleP = orbit.scaleF = 1;
  orbit.scaleP = Math.sqrt(d1) / abs(thetas(orbit, Math.PI / 2).P);
  orbit.scaleF = Math.sqrt(h2) / abs(thetas(orbit, 0).F);
  orbit.turn = 0;
  orbit.mirror = 1;
  orbit.shift = 0;
  const p = locate(orbit, 0);
  orbit.turn = -Math.atan2(p[1], p[0]);
  return orbit;
}

function orbitFromHeights(l, g, z1, z2) {
  const d1 = l + z1, d2 = l + z2, h1 = l - z1, h2 = l - z2, s = -(z1 + z2);
  return orbitFromGaps(l, g, { d1, d2, h1, h2, e3: d1 * d2 / s, s, D: z1 - z2 });                     // (10)
}

// From a position on the sphere and a velocity along it, [S6.4] and [S6.5].
function orbitFromState(l, g, [x, y, z], v) {
  const v2 = v[0] ** 2 + v[1] ** 2 + v[2] ** 2, r2 = x * x + y * y, rise = z < 0 ? r2 / (l - z) : l + z, gap = z < 0 ? l - z : r2 / (l + z);
  const mirror = x * v[1] - y * v[0] < 0 ? -1 : 1, c2 = mirror * (x * v[1] - y * v[0]);
  const epsilon = v2 / (2 * g) - gap, j = c2 * c2 / (2 * g), size = Math.abs(epsilon);
  let u = Math.max(j / (2 * l), 0) ** 0.5 + size + Math.cbrt(j);                                    // beyond the root
  for (let i = 0; i < 200; i++) {
    const [A, B, C] = epsilon < 0 ? [u, u + size, u + 2 * l] : [u, u + size, u + size + 2 * l];
    const step = (A * B * C - j) / (A * B + B * C + C * A);
    if (!(step > 1e-17 * u)) break;
    u -= step;
  }
  u = Math.max(u, 0);
  const [e3, s] = epsilon < 0 ? [u, u + size] : [u + size, u], z3z = e3 + gap;
  const ab = (l * v[2]) ** 2 / (2 * g) / z3z, difference = (ab - (z * v2 / g + r2)) / z3z, D = Math.hypot(difference, 2 * Math.sqrt(ab));
  const larger = (D + Math.abs(difference)) / 2, smaller = larger > 0 ? ab / larger : 0;
  const [a, b] = difference > 0 ? [larger, smaller] : [smaller, larger];
  const d1 = rise + a, h2 = gap + b, orbit = orbitFromGaps(l, g, { d1, d2: s * e3 / d1, h1: s * (e3 + 2 * l) / h2, h2, e3, s, D });
  const rate = 2 * orbit.K / orbit.T, down = v[2] < 0 ? 1 : -1;
  orbit.shift = D === 0 ? 0 : a < b ? down * Math.sqrt(a) * carlsonRF(orbit.kk * b, orbit.kk * D, a + orbit.kk * b) / rate
    : orbit.T / 2 - down * Math.sqrt(b) * carlsonRF(a, a + orbit.kk * b, D) / rate;
  const start = locate(orbit, 0);
  orbit.mirror = mirror;
  orbit.turn += Math.atan2(mirror * y, x) - Math.atan2(start[1], start[0]);
  return orbit;
}

const abs = ([re, im]) => Math.hypot(re, im);

// The theta functions of [S5.1] at v, counted from the lowest point: P/D and F/D.
function thetas(orbit, v) {
  const { q, b, b1 } = orbit;
  let P = [0, 0], F = [1, 0], D = 1;
  for (let n = 0; n < 60; n++) {
    const m = 2 * n + 1, power = q ** (n * n), up = Math.exp(2 * n * b1) * q ** n, sign = n % 2 ? -1 : 1;
    const small = -Math.expm1(-2 * m * b1);                                                        // 1 - eta1*^m
    P[0] += sign * power * up * small * Math.cos(m * v);
    P[1] += sign * power * up * (2 - small) * Math.sin(m * v);
    if (n > 0) {
      F[0] += power * 2 * Math.cosh(2 * n * b) * Math.cos(2 * n * v);
      F[1] -= power * 2 * Math.sinh(2 * n * b) * Math.sin(2 * n * v);
      D += sign * 2 * power * Math.cos(2 * n * v);
    }
    if (n > 0 && power * Math.exp(2 * n * b) < 1e-19) break;
  }
  P = P.map(p => p * orbit.scaleP / D);
  F = F.map(f => f * orbit.scaleF / D);
  return { P, F };
}

// The position at a time.
function locate(orbit, t) {
  const { T, l } = orbit;
  const half = (t + orbit.shift) / T - 0.5, whole = Math.round(half), v = Math.PI * (half - whole);    // whole periods apart
  const { P, F } = thetas(orbit, v);
  const angle = orbit.lambda * T * half + Math.PI * (whole % 2) + orbit.turn, c = Math.cos(angle), s = Math.sin(angle);
  const re = P[0] * F[0] - P[1] * F[1], im = P[0] * F[1] + P[1] * F[0];
  const rise = P[0] ** 2 + P[1] ** 2, gap = F[0] ** 2 + F[1] ** 2;
  return [re * c - im * s, orbit.mirror * (re * s + im * c), rise < l ? rise - l : l - gap];
}

// ---- The picture: seen from above on the left, from the side on the right. Press, draw away, let go: the weight is thrown. ----

function startPicture(canvas, text) {
  const pen = canvas.getContext("2d"), l = 1, g = 9.80665;
  let orbit = orbitFromState(l, g, [0.8, 0, -0.6], [0, 1.2, 0]), begin = performance.now(), press = null, drawn = null;
  const radius = () => Math.min(canvas.width / 4, canvas.height / 2) * 0.9;
  const centre = () => [canvas.width / 4, canvas.height / 2];
  const where = event => {
    const box = canvas.getBoundingClientRect(), [cx, cy] = centre();
    return [((event.clientX - box.left) * canvas.width / box.width - cx) / radius(), -((event.clientY - box.top) * canvas.height / box.height - cy) / radius()];
  };
  canvas.onpointerdown = event => {
    const [x, y] = where(event);
    if (Math.hypot(x, y) < 0.98) { press = [x, y]; drawn = press; canvas.setPointerCapture(event.pointerId); }
  };
  canvas.onpointermove = event => { if (press) drawn = where(event); };
  canvas.onpointerup = () => {
    if (!press) return;
    const [x, y] = press, z = -Math.sqrt(l * l - x * x - y * y), vx = 4 * (drawn[0] - x), vy = 4 * (drawn[1] - y);
    // A vertical plane and a rest have formulas of their own; the weight is thrown a little beside.
    const aside = Math.abs(x * vy - y * vx) < 1e-6 ? 1e-3 : 0, w = [vx - aside * y - aside * 0.1, vy + aside * x];
    orbit = orbitFromState(l, g, [x, y, z], [w[0], w[1], -(x * w[0] + y * w[1]) / z]);
    begin = performance.now();
    press = null;
  };
  function frame(now) {
    const t = (now - begin) / 1000, [cx, cy] = centre(), R = radius(), side = cx + canvas.width / 2;
    pen.clearRect(0, 0, canvas.width, canvas.height);
    pen.lineWidth = 1;
    pen.strokeStyle = "#999";
    for (const at of [cx, side]) { pen.beginPath(); pen.arc(at, cy, R, 0, 2 * Math.PI); pen.stroke(); }
    pen.strokeStyle = "#2a6fb0";
    for (const isSide of [false, true]) {
      pen.beginPath();
      for (let i = 0; i <= 600; i++) {
        const [x, y, z] = locate(orbit, t - 6 * (1 - i / 600) * orbit.T);
        pen.lineTo(isSide ? side + x * R : cx + x * R, cy - (isSide ? z : y) * R);
      }
      pen.stroke();
    }
    const [x, y, z] = locate(orbit, t);
    pen.strokeStyle = pen.fillStyle = "#c33";
    for (const [at, height] of [[cx, y], [side, z]]) {
      pen.beginPath(); pen.moveTo(at, cy); pen.lineTo(at + x * R, cy - height * R); pen.stroke();
      pen.beginPath(); pen.arc(at + x * R, cy - height * R, 7, 0, 2 * Math.PI); pen.fill();
    }
    if (press) { pen.beginPath(); pen.moveTo(cx + press[0] * R, cy - press[1] * R); pen.lineTo(cx + drawn[0] * R, cy - drawn[1] * R); pen.stroke(); }
    text.textContent = `from one highest point to the next ${orbit.T.toFixed(6)} s, the path turns by ${(orbit.lambda * orbit.T * 180 / Math.PI).toFixed(4)} degrees meanwhile; at ${x.toFixed(4)}, ${y.toFixed(4)}, ${z.toFixed(4)} m`;
    requestAnimationFrame(frame);
  }
  requestAnimationFrame(frame);
}
