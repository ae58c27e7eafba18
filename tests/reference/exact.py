"""Exact references for the scenarios that README.md lists.

Run `python exact.py` to write exact.json beside this file (needs mpmath, else
only the standard library). Every scenario is one function: keyword parameters
in, a dictionary of exact values out. SI units, radians, y is up, g > 0 is the
magnitude of gravity, quaternions are (w, x, y, z) with w >= 0, body to world.
Parameters may be numbers or strings such as "1/60"; a float is read as the
decimal it prints as, so 9.81 means exactly 9.81.
"""
import json
import struct
from fractions import Fraction
from pathlib import Path

from mpmath import (agm, asin, atan, atan2, ceil, cos, eigsy, ellipf, ellipfun, ellipk,
                    ellippi, erf, exp, floor, laguerre, log, matrix, mp, mpf, nint, pi,
                    polyroots, quad, sign, sin, sqrt, tan, taylor)

mp.dps = 40


# --- numbers in, numbers out -------------------------------------------------

def num(x):
    """One parameter as an mpf: number, decimal string or fraction string."""
    if isinstance(x, mpf):
        return x
    f = Fraction(str(x))
    return mpf(f.numerator) / f.denominator


def nums(xs):
    """A list of parameters as mpf."""
    return [num(x) for x in xs]


def plain(x):
    """Results as JSON values: every mpf becomes the nearest f64."""
    if isinstance(x, dict):
        return {k: plain(v) for k, v in x.items()}
    if isinstance(x, (list, tuple)):
        return [plain(v) for v in x]
    if isinstance(x, mpf):
        return float(x)
    return float(Fraction(x)) if isinstance(x, str) and "/" in x else x


def dot(a, b):
    """Scalar product."""
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    """Vector product a x b (3D)."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def norm(a):
    """Euclidean length."""
    return sqrt(dot(a, a))


def matmul(a, b):
    """Product of two matrices held as lists of rows."""
    return [[sum(r[k] * b[k][j] for k in range(len(b))) for j in range(len(b[0]))] for r in a]


def transpose(a):
    """Transpose of a matrix held as a list of rows."""
    return [list(r) for r in zip(*a)]


# --- 1-3: point integration --------------------------------------------------

def projectile(p, v, g, t):
    """x(t) = p + v t - g t^2/2 e_y.  [m, m/s, m/s^2, s]  Newton, constant force."""
    p, v, g, t = nums(p), nums(v), num(g), num(t)
    x = [a + b * t for a, b in zip(p, v)]
    x[1] -= g * t * t / 2
    return x


def verlet_startup(p, v, g, dt, t):
    """Position Verlet x+ = 2x - p* + a dt^2 from p* = p - v dt ("plain").

    n steps give x0 + v t + a dt^2 n(n+1)/2, so the error is a dt t/2 [m], first
    order; p* = p - v dt + a dt^2/2 makes it exactly 0.  Induction on n.
    """
    return {"end_position": projectile(p, v, g, t),
            "plain_start_error": num(g) * num(dt) * num(t) / 2,
            "corrected_start_error": mpf(0)}


def verlet_run(x0, v0, a, steps, rule):
    """End position of one coordinate after position Verlet over the steps [s].

    rule "uncorrected": x+ = x + (x-p) + a dt^2; "ratio_only": x+ = x + (x-p) dt/dt*
    + a dt^2; "exact": x+ = x + (x-p) dt/dt* + a dt (dt+dt*)/2 with dt* the previous
    step.  Start p = x0 - v0 dt + a dt^2/2 with the first dt.
    """
    prev = steps[0]
    x, p = x0, x0 - v0 * prev + a * prev * prev / 2
    for h in steps:
        drift = x - p if rule == "uncorrected" else (x - p) * h / prev
        kick = a * h * (h + prev) / 2 if rule == "exact" else a * h * h
        x, p, prev = x + drift + kick, x, h
    return x


def variable_dt(p, v, g, runs):
    """Exact end and the error of three Verlet rules over a given dt sequence.

    runs: list of [dt sequence, repeats]; the sequences are played in order.
    Taylor: x(t+dt)-x = v dt + a dt^2/2 and x-x(t-dt*) = v dt* - a dt*^2/2; eliminate
    v: the "exact" rule of verlet_run has no error when a is constant.
    """
    steps = [num(h) for seq, times in runs for _ in range(times) for h in seq]
    total = sum(steps)
    end = projectile(p, v, g, total)
    error = {}
    for rule in ("uncorrected", "ratio_only", "exact"):
        x = verlet_run(num(p[0]), num(v[0]), mpf(0), steps, rule)
        y = verlet_run(num(p[1]), num(v[1]), -num(g), steps, rule)
        error[rule] = [x - end[0], y - end[1]]
    return {"steps": len(steps), "total_time": total, "end_position": end,
            "end_error_xy": error}


def f32(x):
    """The nearest IEEE binary32 number."""
    return struct.unpack("f", struct.pack("f", x))[0]


def f32_stall(g, dt, substeps):
    """Height above which position Verlet in f32 never starts to fall [m].

    With x = p the new position is fl(y - g h^2), h = dt/substeps.  It equals y when
    g h^2 < ulp(y)/2 = 2^(floor(log2 y) - 24), that is y > 2^(floor(log2(g h^2)) + 25)
    (unless g h^2 is itself a power of two).  IEEE 754 round to nearest.
    """
    rows = []
    for n in substeps:
        inc = num(g) * (num(dt) / n) ** 2
        rows.append({"substeps": n, "increment": inc,
                     "stalls_above": mpf(2) ** (floor(log(inc, 2)) + 25)})
    return {"rows": rows}


# --- 4-8: rotation -----------------------------------------------------------

def box_inertia(half, mass):
    """I_i = m/3 (h_j^2 + h_k^2) for half-extents h [kg m^2].  Solid box."""
    a, b, c = (num(h) ** 2 for h in half)
    return [num(mass) / 3 * s for s in (b + c, a + c, a + b)]


def amplitude(u, m):
    """Jacobi amplitude am(u|m), continuous in u.  DLMF 22.16(i)."""
    phi = atan2(ellipfun("sn", u, m=m), ellipfun("cn", u, m=m))
    return phi + 2 * pi * nint((u * pi / (2 * ellipk(m)) - phi) / (2 * pi))


def top_axes(inertia, omega):
    """Rows: right-handed axes (1,2,3) for the elliptic formulas, in the body frame.

    2 has the middle moment; 3 the largest when L^2 >= 2T I_2, else the smallest.
    """
    low, mid, high = sorted(range(3), key=lambda i: inertia[i])
    momentum2 = sum((i * w) ** 2 for i, w in zip(inertia, omega))
    energy2 = sum(i * w * w for i, w in zip(inertia, omega))
    order = (low, mid, high) if momentum2 >= energy2 * inertia[mid] else (high, mid, low)
    rows = [[mpf(int(j == i)) for j in range(3)] for i in order]
    if order not in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        rows[0] = [-x for x in rows[0]]
    return rows


def top_constants(inertia, omega):
    """Constants of the torque-free asymmetric top in the frame of top_axes.

    T2 = 2T, L = |I w|:  p^2 = (I3-I2)(L^2-T2 I1)/(I1 I2 I3), p takes the sign of
    I3-I1;  m = (I2-I1)(T2 I3-L^2)/((I3-I2)(L^2-T2 I1));  A1^2 = (T2 I3-L^2)/(I1(I3-I1)),
    A2^2 = (T2 I3-L^2)/(I2(I3-I2)), A3^2 = (L^2-T2 I1)/(I3(I3-I1)).
    Landau & Lifshitz, Mechanics, section 37; van Zon & Schofield 2007.
    """
    axes = top_axes(inertia, omega)
    i1, i2, i3 = (dot([abs(x) for x in row], inertia) for row in axes)
    w = [dot(row, omega) for row in axes]
    t2 = i1 * w[0] ** 2 + i2 * w[1] ** 2 + i3 * w[2] ** 2
    l2 = (i1 * w[0]) ** 2 + (i2 * w[1]) ** 2 + (i3 * w[2]) ** 2
    far, near = t2 * i3 - l2, l2 - t2 * i1
    return {"axes": axes, "I": (i1, i2, i3), "w": w, "L": sqrt(l2), "s": sign(w[2]) or mpf(1),
            "p": sign(i3 - i1) * sqrt((i3 - i2) * near / (i1 * i2 * i3)),
            "m": (i2 - i1) * far / ((i3 - i2) * near),
            "A": (sqrt(far / (i1 * (i3 - i1))), sqrt(far / (i2 * (i3 - i2))),
                  sqrt(near / (i3 * (i3 - i1))))}


def top_phase(c):
    """phi0 = atan2(s w2/A2, w1/A1), the Jacobi amplitude at t = 0 [rad]."""
    return atan2(c["s"] * c["w"][1] / c["A"][1], c["w"][0] / c["A"][0])


def top_omega(c, t):
    """w = (A1 cn, s A2 sn, s A3 dn)(tau|m), tau = p t + F(phi0|m) [rad/s]; and tau."""
    tau = c["p"] * t + ellipf(top_phase(c), c["m"])
    sn, cn, dn = (ellipfun(k, tau, m=c["m"]) for k in ("sn", "cn", "dn"))
    return [c["A"][0] * cn, c["s"] * c["A"][1] * sn, c["s"] * c["A"][2] * dn], tau


def top_precession(c, t, tau):
    """Angle of the node line of axis 3 about the fixed L after time t [rad].

    psi = L t/I3 + L(I3-I1)/(p I1 I3) [Pi(n; am tau|m) - Pi(n; phi0|m)],
    n = -I3(I2-I1)/(I1(I3-I2)); integral of L(I1 w1^2+I2 w2^2)/(L1^2+L2^2).
    """
    i1, i2, i3 = c["I"]
    n = -i3 * (i2 - i1) / (i1 * (i3 - i2))
    turn = ellippi(n, amplitude(tau, c["m"]), c["m"]) - ellippi(n, top_phase(c), c["m"])
    return c["L"] * t / i3 + c["L"] * (i3 - i1) / (c["p"] * i1 * i3) * turn


def node_frame(inertia, omega):
    """Rows e3 x u, u x (e3 x u) and u, unit length, with u = I w/|I w|."""
    u = [i * w for i, w in zip(inertia, omega)]
    u = [x / norm(u) for x in u]
    x = [-u[1], u[0], mpf(0)]
    x = [a / norm(x) for a in x]
    return [x, cross(u, x), u]


def top_state(inertia, omega, t):
    """Body w(t) and R(t) (body to world) of a free top with R(0) = 1.

    R = P^T B(0)^T Rz(psi) B(t) P: B from node_frame, P from top_axes.
    """
    c = top_constants(inertia, omega)
    w, tau = top_omega(c, t)
    psi = top_precession(c, t, tau)
    rz = [[cos(psi), -sin(psi), mpf(0)], [sin(psi), cos(psi), mpf(0)], [mpf(0), mpf(0), mpf(1)]]
    start, now = node_frame(c["I"], c["w"]), node_frame(c["I"], w)
    r = matmul(matmul(transpose(start), rz), now)
    r = matmul(matmul(transpose(c["axes"]), r), c["axes"])
    return [dot(col, w) for col in transpose(c["axes"])], r


def quaternion(r):
    """Unit quaternion (w,x,y,z), w >= 0, of a rotation matrix.  Shepperd 1978."""
    trace = r[0][0] + r[1][1] + r[2][2]
    best = max(range(4), key=lambda k: trace if k == 0 else r[k - 1][k - 1])
    if best == 0:
        q = [1 + trace, r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]]
    else:
        i = best - 1
        j, k = (i + 1) % 3, (i + 2) % 3
        q = [r[k][j] - r[j][k], 0, 0, 0]
        q[1 + i], q[1 + j], q[1 + k] = 1 + 2 * r[i][i] - trace, r[j][i] + r[i][j], r[k][i] + r[i][k]
    size = norm(q) * (-1 if q[0] < 0 else 1)
    return [x / size for x in q]


def rotation_error(r, exact):
    """Angle between two rotations: 2 asin(|R - Re|_F / sqrt 8) [rad]."""
    s = sqrt(sum((a - b) ** 2 for x, y in zip(r, exact) for a, b in zip(x, y)) / 8)
    return 2 * asin(min(s, mpf(1)))


def free_top(half, mass, omega, times):
    """Free box: body w, attitude and conserved L, T at the given times."""
    inertia, omega = box_inertia(half, mass), nums(omega)
    c = top_constants(inertia, omega)
    rows = []
    for t in times:
        w, r = top_state(inertia, omega, num(t))
        rows.append({"t": num(t), "quaternion_wxyz": quaternion(r), "rotation_rows": r,
                     "omega_body": w})
    return {"inertia": inertia, "m": c["m"], "p": abs(c["p"]),
            "omega_period": 4 * ellipk(c["m"]) / abs(c["p"]),
            "angular_momentum_world": [i * w for i, w in zip(inertia, omega)],
            "kinetic_energy": sum(i * w * w for i, w in zip(inertia, omega)) / 2, "rows": rows}


def flip(inertia, omega):
    """Dzhanibekov: w_2 repeats after 4K(m)/p and changes sign every 2K(m)/p [s].

    First zero of w_2 after t = 0 included.  K complete elliptic integral, DLMF 19.2.
    """
    c = top_constants(nums(inertia), nums(omega))
    k, p = ellipk(c["m"]), abs(c["p"])
    start = ellipf(top_phase(c), c["m"]) * sign(c["p"])
    first = (-start) % (2 * k)
    return {"m": c["m"], "p": p, "time_between_flips": 2 * k / p, "full_period": 4 * k / p,
            "first_zero_of_omega_2": first / p}


def xpbd_spin(omega0, h, t):
    """First-order quaternion update, normalised, with w = 2 vec(q q0*)/h.

    One step maps w to w/sqrt(1+(w h/2)^2) about a principal axis, so 1/w^2 grows by
    (h/2)^2 and w_n = w0/sqrt(1+n(w0 h/2)^2) [rad/s].  angle = sum 2 atan(w_k h/2).
    """
    w, h = num(omega0), num(h)
    n = int(nint(num(t) / h))
    at = [w / sqrt(1 + k * (w * h / 2) ** 2) for k in range(n + 1)]
    turned = sum(2 * atan(x * h / 2) for x in at[:-1])
    return {"steps": n, "omega_end": at[-1], "kept_fraction": at[-1] / w,
            "angle_turned": turned, "angle_exact": w * n * h}


def omega_alias(omegas, dt):
    """Spin read back from two attitudes: the wrap of w dt into (-pi, pi] over dt.

    Sampling cannot tell w from w - 2 pi k/dt; limit |w| dt < pi.  chord = 2 sin(w dt/2)/dt
    is what 2 vec(q q0*)/dt gives without the sign fix.
    """
    dt = num(dt)
    rows = []
    for w in nums(omegas):
        turns = ceil((w * dt / pi - 1) / 2)
        rows.append({"omega": w, "read_back": w - 2 * pi * turns / dt,
                     "chord": 2 * sin(w * dt / 2) / dt})
    return {"limit": pi / dt, "rows": rows}


def heavy_top(mass, i1, i3, d, theta0, omega3, g):
    """Lagrange top released at theta0 with spin omega3 only.  I1, I3 about the pivot.

    u = cos theta: u'^2 = b (u0-u)(u-u1)(u2-u), b = 2Mgd/I1, u1 < u0 < 1 < u2 roots of
    b(1-u^2) = (I3 w3/I1)^2 (u0-u).  Period 4K((u0-u1)/(u2-u1))/sqrt(b(u2-u1)) [s];
    phi' = I3 w3 (u0-u)/(I1(1-u^2)); steady precession at theta0: I1 cos(theta0) W^2 -
    I3 w3 W + Mgd = 0 [rad/s].  A real body needs I1 >= M d^2 + I3/2.  Goldstein ch. 5.
    """
    mass, i1, i3, d, theta0, omega3, g = nums((mass, i1, i3, d, theta0, omega3, g))
    spin, b, u0 = i3 * omega3, 2 * mass * g * d / i1, cos(theta0)
    half = (spin / i1) ** 2 / (2 * b)
    root = sqrt(half ** 2 - 2 * half * u0 + 1)
    u1, u2 = half - root, half + root
    period = 4 * ellipk((u0 - u1) / (u2 - u1)) / sqrt(b * (u2 - u1))

    def advance(s):
        u = u0 - (u0 - u1) * sin(s) ** 2
        return spin * (u0 - u) / (i1 * (1 - u * u)) * 4 / sqrt(b * (u2 - u))

    disc = spin ** 2 - 4 * i1 * u0 * mass * g * d
    out = {"buildable": bool(i1 >= mass * d * d + i3 / 2), "nutation_period": period,
           "theta_max": mp.acos(u1), "mean_precession": quad(advance, [0, pi / 2]) / period}
    if disc >= 0:
        out["steady_slow"] = (spin - sqrt(disc)) / (2 * i1 * u0)
        out["steady_fast"] = (spin + sqrt(disc)) / (2 * i1 * u0)
    return out


# --- 9-10: pendulum and chain ------------------------------------------------

def pendulum(length, g, amplitudes, t):
    """T = 2 pi sqrt(l/g)/agm(1, cos(theta0/2)) [s] and theta(t) after release at rest.

    sin(theta/2) = k cd(t sqrt(g/l)|k^2), k = sin(theta0/2).  DLMF 19.8, 22.19.  For a
    rigid body l = I_pivot/(M d).
    """
    length, g, t = num(length), num(g), num(t)
    rows = []
    for a in nums(amplitudes):
        k, u = sin(a / 2), t * sqrt(g / length)
        cd = ellipfun("cd", u, m=k * k)
        rows.append({"theta0": a, "period": 2 * pi * sqrt(length / g) / agm(1, cos(a / 2)),
                     "theta_at_t": 2 * asin(k * cd),
                     "speed_at_bottom": 2 * k * sqrt(g * length)})
    return {"t": t, "rows": rows}


def laguerre_zeros(n):
    """The n zeros of the Laguerre polynomial L_n, ascending.  DLMF 18.2."""
    coefficients = taylor(lambda x: laguerre(n, 0, x), 0, n)[::-1]
    return sorted(z.real for z in polyroots(coefficients, maxsteps=400, extraprec=400))


def chain_matrices(n, length, lump):
    """Mass and stiffness (per kg, per g) of n links hanging at small angles.

    lump = 1: point mass at each link's lower end; lump = 1/2: uniform thin rods.
    Coordinates: angles; centre of link i moves sum_{j<i} l th_j + lump l th_i.
    """
    mass, stiff = matrix(n, n), matrix(n, n)
    for i in range(n):
        arm = [length if j < i else lump * length if j == i else mpf(0) for j in range(n)]
        for j in range(i + 1):
            stiff[j, j] += arm[j]
            for k in range(i + 1):
                mass[j, k] += arm[j] * arm[k]
        if lump != 1:
            mass[i, i] += length ** 2 / 12
    return mass, stiff


def chain_modes(links, link_length, g):
    """Small planar modes of a hanging chain [rad/s], lowest first.

    Point masses: w_k^2 = g x_k/l with x_k the zeros of L_n (n = number of links).
    Uniform rods with ideal joints: w^2 M a = g K a from chain_matrices.  Continuous
    limit: j_{0,1} sqrt(g/(4 n l)).
    """
    length, g = num(link_length), num(g)
    zeros = laguerre_zeros(links)
    mass, stiff = chain_matrices(links, length, mpf(1) / 2)
    scaled = matrix(links, links)
    for i in range(links):
        for j in range(links):
            scaled[i, j] = mass[i, j] / sqrt(stiff[i, i] * stiff[j, j])
    rods = sorted(sqrt(g / x) for x in eigsy(scaled, eigvals_only=True))
    return {"laguerre_first_zero": zeros[0], "point_masses": [sqrt(g * x / length) for x in zeros],
            "uniform_rods": rods, "first_period_point_masses": 2 * pi / sqrt(g * zeros[0] / length),
            "first_period_uniform_rods": 2 * pi / rods[0],
            "continuous_first": mp.besseljzero(0, 1) * sqrt(g / (4 * links * length))}


# --- 11-17: contact ----------------------------------------------------------

def bounce(z0, r, e, g, hits, t):
    """Ball dropped from rest, centre at z0, on a plane at 0, restitution e.

    t_1 = sqrt(2(z0-r)/g); t_n = t_1 (1 + 2 sum_{k=1}^{n-1} e^k) = t_1 (1+e-2e^n)/(1-e);
    apex n at r + (z0-r) e^(2n), time t_n + e^n t_1; at rest after t_1 (1+e)/(1-e) [s, m].
    """
    z0, r, e, g, t = nums((z0, r, e, g, t))
    t1 = sqrt(2 * (z0 - r) / g)
    when = [t1 * (1 + 2 * sum(e ** k for k in range(1, n))) for n in range(1, hits + 1)]
    apex = [{"t": w + e ** n * t1, "z": r + (z0 - r) * e ** (2 * n)} for n, w in enumerate(when, 1)]
    return {"hit_times": when, "apexes": apex, "t": t, "z_at_t": bounce_height(z0, r, e, g, t),
            "rest_time": t1 * (1 + e) / (1 - e) if e < 1 else None}


def bounce_height(z0, r, e, g, t):
    """Centre height at t for bounce(): ballistic arc between the exact hits [m]."""
    t1 = sqrt(2 * (z0 - r) / g)
    if t <= t1:
        return z0 - g * t * t / 2
    n, hit = 1, t1
    while hit + 2 * e ** n * t1 <= t:
        hit, n = hit + 2 * e ** n * t1, n + 1
        if e ** n * t1 < mpf(10) ** -30:
            return r
    return r + g * e ** n * t1 * (t - hit) - g * (t - hit) ** 2 / 2


def slip_to_roll(v, mu, g, r, t):
    """Sliding solid sphere, no spin: slips until t* = 2v/(7 mu g), then rolls at 5v/7.

    x(t) = v t - mu g t^2/2 up to t*, then x(t*) + 5v/7 (t-t*); spin = 5v/(7r) [rad/s].
    Coriolis; angular momentum about the contact point is conserved.
    """
    v, mu, g, r, t = nums((v, mu, g, r, t))
    stop = 2 * v / (7 * mu * g)
    slip = min(t, stop)
    x = v * slip - mu * g * slip ** 2 / 2 + 5 * v / 7 * (t - slip)
    return {"roll_time": stop, "final_v": 5 * v / 7, "final_spin": 5 * v / (7 * r),
            "x_at_t": x, "kinetic_energy_kept": mpf(5) / 7}


def incline(angle_deg, mu, r, g, t):
    """Solid sphere released at rest on a plane of the given slope.

    Rolls if tan(theta) <= 7 mu/2: a = 5/7 g sin(theta), spin rate a/r; else slips:
    a = g(sin - mu cos), spin rate 5 mu g cos/(2 r).  Distance a t^2/2 along the slope.
    """
    theta, mu, r, g, t = num(angle_deg) * pi / 180, num(mu), num(r), num(g), num(t)
    rolls = tan(theta) <= mpf(7) / 2 * mu
    a = mpf(5) / 7 * g * sin(theta) if rolls else g * (sin(theta) - mu * cos(theta))
    spin = a / r if rolls else 5 * mu * g * cos(theta) / (2 * r)
    return {"rolls": bool(rolls), "threshold_deg": atan(mpf(7) / 2 * mu) * 180 / pi,
            "acceleration": a, "distance": a * t * t / 2, "speed": a * t, "spin": spin * t}


def balls_on_box(force, box_mass, ball_mass, balls, mu_ground, mu_ball, g, t):
    """n solid balls on a box that is pushed over rough ground (SimBenchmark "rolling").

    f1 = mu_ground (M+n m) g; no slip at the balls: f2 (7/(2m) + n/M) = (F-f1)/M;
    a_ball = f2/m, a_box = 7/2 a_ball.  Valid while f2 <= mu_ball m g.
    """
    f, big, m, mu1, mu2, g, t = nums((force, box_mass, ball_mass, mu_ground, mu_ball, g, t))
    f1 = mu1 * (big + balls * m) * g
    f2 = (f - f1) / big / (mpf(7) / 2 / m + balls / big)
    return {"ground_friction": f1, "ball_friction": f2, "ball_grips": bool(f2 <= mu2 * m * g),
            "a_box": mpf(7) / 2 * f2 / m, "a_ball": f2 / m,
            "v_box_at_t": mpf(7) / 2 * f2 / m * t, "v_ball_at_t": f2 / m * t}


def sliding_stop(v, mu, g, angles_deg):
    """Box sliding on a plane: stops after v^2/(2 mu g) in every direction [m].

    A friction pyramid (limit mu N on each axis apart) instead stops after
    v^2/(2 mu g) sqrt(cos^4 a + sin^4 a) in the direction atan(tan^2 a).
    """
    v, mu, g = nums((v, mu, g))
    d = v * v / (2 * mu * g)
    rows = []
    for a in nums(angles_deg):
        c, s = cos(a * pi / 180) ** 2, sin(a * pi / 180) ** 2
        rows.append({"angle_deg": a, "distance": d, "pyramid_distance": d * sqrt(c * c + s * s),
                     "pyramid_angle_deg": atan2(s, c) * 180 / pi})
    return {"distance": d, "stop_time": v / (mu * g), "rows": rows}


def head_on(m1, m2, v1, v2, e):
    """Central impact: v1' = v1 - (1+e) m_r u/m1, v2' = v2 + (1+e) m_r u/m2, u = v1-v2.

    m_r = m1 m2/(m1+m2); energy lost m_r (1-e^2) u^2/2 [J].  Newton's restitution.
    """
    m1, m2, v1, v2, e = nums((m1, m2, v1, v2, e))
    reduced, u = m1 * m2 / (m1 + m2), v1 - v2
    return {"v1": v1 - (1 + e) * reduced * u / m1, "v2": v2 + (1 + e) * reduced * u / m2,
            "momentum": m1 * v1 + m2 * v2, "energy_lost": reduced * (1 - e * e) * u * u / 2}


def oblique_impact(m1, m2, r1, r2, v1, v2, w1, w2, normal, e, mu):
    """Two solid spheres, Newton restitution and Coulomb friction, one impulse.

    n from 1 to 2; u = v1 + w1 x r1 n - v2 + w2 x r2 n; J_n = (1+e) m_r u.n;
    J_t = min(mu J_n, 2/7 m_r |u_t|) against u_t (I = 2/5 m r^2, both spheres).
    """
    m1, m2, r1, r2, e, mu = nums((m1, m2, r1, r2, e, mu))
    v1, v2, w1, w2, n = nums(v1), nums(v2), nums(w1), nums(w2), nums(normal)
    n = [x / norm(n) for x in n]
    c1, c2 = cross(w1, n), cross(w2, n)
    u = [a + r1 * b - c + r2 * d for a, b, c, d in zip(v1, c1, v2, c2)]
    un = dot(u, n)
    ut = [a - un * b for a, b in zip(u, n)]
    reduced, size = m1 * m2 / (m1 + m2), norm(ut)
    jn = (1 + e) * reduced * un
    stick = mpf(2) / 7 * reduced * size
    jt = min(mu * jn, stick)
    tangent = [x / size if size else mpf(0) for x in ut]
    j = [-jn * a - jt * b for a, b in zip(n, tangent)]
    turn = cross(n, j)
    return {"normal_impulse": jn, "tangent_impulse": jt, "sticks": bool(jt == stick),
            "v1": [a + b / m1 for a, b in zip(v1, j)], "v2": [a - b / m2 for a, b in zip(v2, j)],
            "w1": [a + 5 * b / (2 * m1 * r1) for a, b in zip(w1, turn)],
            "w2": [a + 5 * b / (2 * m2 * r2) for a, b in zip(w2, turn)]}


def cradle(balls, moving, v):
    """Newton's cradle, equal masses, e = 1: k in, the last k out with speed v.

    one_shot is what a solver gives that treats touching contacts at once with
    Newton's rule, k = 1: first ball (2/N-1) v, all others 2v/N; it keeps momentum and energy.
    """
    v = num(v)
    out = [mpf(0)] * (balls - moving) + [v] * moving
    shot = [(mpf(2) / balls - 1) * v] + [2 * v / balls] * (balls - 1)
    return {"exact": out, "one_shot": shot if moving == 1 else None}


# --- 18-24: crowds -----------------------------------------------------------

def hard_sphere_gas(number, side, diameter, kt_over_m, dt):
    """Elastic hard spheres in a periodic cube, Enskog theory.

    n = N/V, phi = pi n d^3/6, chi = (1-phi/2)/(1-phi)^3 (Carnahan-Starling).  Rate per
    particle 4 n d^2 sqrt(pi kT/m) chi [1/s]; pair collisions per volume n/2 times that,
    in the box N/2 times.  Z = PV/NkT = 1 + 4 phi chi.  Maxwell speeds: mean
    sqrt(8kT/pi m), rms sqrt(3kT/m), P(speed < s) = erf(y) - 2 y exp(-y^2)/sqrt(pi),
    y = s/sqrt(2kT/m).  Chapman & Cowling; Carnahan & Starling 1969.
    """
    side, d, kt, dt = nums((side, diameter, kt_over_m, dt))
    n = number / side ** 3
    phi = pi * n * d ** 3 / 6
    chi = (1 - phi / 2) / (1 - phi) ** 3
    rate = 4 * n * d * d * sqrt(pi * kt) * chi
    mean = sqrt(8 * kt / pi)
    y = mean / sqrt(2 * kt)
    return {"packing_fraction": phi, "chi": chi, "rate_per_particle": rate,
            "pair_collisions_per_second_in_box": number * rate / 2,
            "pair_collisions_per_second_per_volume": n * rate / 2,
            "mean_free_path": mean / rate, "compressibility_Z": 1 + 4 * phi * chi,
            "mean_speed": mean, "rms_speed": sqrt(3 * kt), "most_probable_speed": sqrt(2 * kt),
            "mean_v4": 15 * kt * kt, "fraction_below_mean": erf(y) - 2 * y * exp(-y * y) / sqrt(pi),
            "collisions_per_particle_per_step": rate * dt}


def sweep_factor(masses):
    """Gauss-Seidel error factor per sweep for a vertical chain of contacts or joints.

    Contact k joins body k-1 (k = 0: the world) and body k: W_kk = 1/m_{k-1} + 1/m_k,
    W_{k,k+1} = -1/m_k.  The factor is the square of Jacobi's (Young).  Equal masses:
    cos^2(pi/2n); k:1 heavy on light: k/(k+1).
    """
    inv = [1 / num(m) for m in masses]
    size = len(inv)
    diagonal = [inv[k] + (inv[k - 1] if k else 0) for k in range(size)]
    j = matrix(size, size)
    for k in range(size - 1):
        j[k, k + 1] = j[k + 1, k] = inv[k] / sqrt(diagonal[k] * diagonal[k + 1])
    return max(eigsy(j, eigvals_only=True)) ** 2


def stack(masses, g, heights, target):
    """Bodies resting on each other, ground upwards: contact forces and solver cost.

    Force in contact k = g (sum of masses above it) [N]; centres at exact rest heights
    [m]; sweeps = ln(target)/ln(sweep_factor) from a cold start.
    """
    m, h, g, target = nums(masses), nums(heights), num(g), num(target)
    factor = sweep_factor(masses)
    return {"contact_forces": [g * sum(m[k:]) for k in range(len(m))],
            "rest_centres": [sum(h[:k]) + h[k] / 2 for k in range(len(h))],
            "total_height": sum(h), "sweep_factor": factor,
            "sweeps_to_target": log(target) / log(factor)}


def ball_and_chain(links, link_mass, link_length, ball_mass, g, target):
    """Chain of links from the world with a ball at its end: rest length and tensions.

    Tension in joint k = g (mass below); exact stretch is 0; sweeps as in stack.
    """
    m = [num(link_mass)] * links + [num(ball_mass)]
    factor = sweep_factor(m)
    return {"joint_tensions": [num(g) * sum(m[k:]) for k in range(links + 1)],
            "rest_length": links * num(link_length), "exact_stretch": mpf(0),
            "sweep_factor": factor, "sweeps_to_target": log(num(target)) / log(factor)}


def uncovered(step, r, wall):
    """Chance that no sample, one every `step` metres, lies within r of either face.

    Two intervals of length 2r start w apart; on a circle of length s they cover
    4r - max(0, 2r-q) - max(0, 2r-s+q), q = w mod s, or all of it when 2r >= s.
    """
    if 2 * r >= step:
        return mpf(0)
    q = wall % step
    cover = 4 * r - max(mpf(0), 2 * r - q) - max(mpf(0), 2 * r - step + q)
    return max(mpf(0), 1 - cover / step)


def tunnelling(r, wall, dt, speeds):
    """Probability that a ball crosses a wall when contacts are looked for once a step.

    Steps s = v dt with a random phase.  "unseen": no sample has overlap, interval of
    centres 2r+w: max(0, 1-(2r+w)/s).  "wrong_side": no sample overlaps before the
    centre passes the mid-plane, interval r+w/2: max(0, 1-(r+w/2)/s).  "_surface_only":
    a centre deeper than r inside the wall has no contact; same unless w > 2r.
    """
    r, wall, dt = nums((r, wall, dt))
    rows = []
    for v in nums(speeds):
        s = v * dt
        rows.append({"v": v, "unseen": max(mpf(0), 1 - (2 * r + wall) / s),
                     "wrong_side": max(mpf(0), 1 - (r + wall / 2) / s),
                     "unseen_surface_only": uncovered(s, r, wall),
                     "wrong_side_surface_only": max(mpf(0), 1 - (r + min(wall / 2, r)) / s)})
    return {"safe_speed_unseen": (2 * r + wall) / dt, "safe_speed_wrong_side": (r + wall / 2) / dt,
            "rows": rows}


def free_fall_group(mass, com, v, spin_momentum, g, t):
    """Jointed group before its first contact: internal forces cancel.

    Centre of mass as projectile(); momentum M(v - g t e_y); angular momentum about the
    centre of mass constant.
    """
    v_end = nums(v)
    v_end[1] -= num(g) * num(t)
    return {"com": projectile(com, v, g, t), "momentum": [num(mass) * x for x in v_end],
            "angular_momentum_about_com": nums(spin_momentum)}


# --- the table ---------------------------------------------------------------

G = 9.81
SHOT = {"p": [0, 10, 0], "v": [5, 8, 0], "g": G}
ALTERNATING = [[["1/60", "1/30"], 40]]
HITCH = [[["1/60"], 60], [["1/10"], 1], [["1/60"], 54]]

CASES = {
    "01_verlet_startup": (verlet_startup, dict(SHOT, dt="1/60", t=2)),
    "02_variable_dt_alternating": (variable_dt, dict(SHOT, runs=ALTERNATING)),
    "02_variable_dt_hitch": (variable_dt, dict(SHOT, runs=HITCH)),
    "03_f32_stall": (f32_stall, {"g": G, "dt": "1/60", "substeps": [1, 4, 8, 16, 20, 32, 40]}),
    "04_free_top": (free_top, {"half": [0.3, 0.2, 0.1], "mass": 1, "omega": [1, 2, 3],
                               "times": [1, 2, 5, 10]}),
    "05_dzhanibekov": (flip, {"inertia": ["1/60", "1/30", "13/300"], "omega": [0.05, 5, 0.05]}),
    "05_dzhanibekov_attitude": (free_top, {"half": [0.3, 0.2, 0.1], "mass": 1,
                                           "omega": [0.05, 5, 0.05], "times": [1, 2, 5, 10]}),
    "06_xpbd_spin": (xpbd_spin, {"omega0": 10, "h": "1/60", "t": 1}),
    "06_xpbd_spin_20_substeps": (xpbd_spin, {"omega0": 10, "h": "1/1200", "t": 1}),
    "07_omega_alias": (omega_alias, {"omegas": [100, 180, 200, 300, 376, 377], "dt": "1/60"}),
    "08_heavy_top": (heavy_top, {"mass": 1, "i1": 0.05, "i3": 0.02, "d": 0.2, "theta0": 0.5,
                                 "omega3": 60, "g": G}),
    "08_heavy_top_not_buildable": (heavy_top, {"mass": 1, "i1": 0.05, "i3": 0.02, "d": 0.3,
                                               "theta0": 0.5, "omega3": 60, "g": G}),
    "09_pendulum": (pendulum, {"length": 1, "g": G, "amplitudes": [0.1, 1, 2, 3, 3.13], "t": 10}),
    "10_hanging_chain": (chain_modes, {"links": 10, "link_length": 0.1, "g": G}),
    "11_elastic_bounce": (bounce, {"z0": 5, "r": 0.1, "e": 1, "g": G, "hits": 10, "t": 10}),
    "12_inelastic_bounce": (bounce, {"z0": 5, "r": 0.1, "e": 0.5, "g": G, "hits": 8, "t": 2}),
    "13_slip_to_roll": (slip_to_roll, {"v": 4, "mu": 0.3, "g": G, "r": 0.5, "t": 1}),
    "14_incline_rolls": (incline, {"angle_deg": 20, "mu": 0.5, "r": 0.5, "g": G, "t": 1}),
    "14_incline_slips": (incline, {"angle_deg": 60, "mu": 0.3, "r": 0.5, "g": G, "t": 1}),
    "14_balls_on_box": (balls_on_box, {"force": 150, "box_mass": 10, "ball_mass": 1, "balls": 25,
                                       "mu_ground": 0.4, "mu_ball": 0.8, "g": G, "t": 4}),
    "15_friction_isotropy": (sliding_stop, {"v": 4, "mu": 0.5, "g": G,
                                            "angles_deg": [0, 22.5, 45]}),
    "16_oblique_sticks": (oblique_impact, {
        "m1": 1, "m2": 2, "r1": 0.1, "r2": 0.2, "v1": [3, 1, 0], "v2": [-1, 0, 0],
        "w1": [0, 0, 5], "w2": [0, 0, 0], "normal": [1, 0, 0], "e": 0.8, "mu": 0.5}),
    "16_oblique_slips": (oblique_impact, {
        "m1": 1, "m2": 2, "r1": 0.1, "r2": 0.2, "v1": [3, 4, 1], "v2": [-1, 0, 0],
        "w1": [0, 10, 5], "w2": [0, 0, 0], "normal": [1, 0, 0], "e": 0.8, "mu": 0.1}),
    "16_head_on": (head_on, {"m1": 1, "m2": 2, "v1": 3, "v2": -1, "e": 0.8}),
    "17_cradle": (cradle, {"balls": 5, "moving": 1, "v": 1}),
    "17_cradle_two": (cradle, {"balls": 5, "moving": 2, "v": 1}),
    "18_hard_sphere_gas": (hard_sphere_gas, {"number": 1000, "side": 1, "diameter": 0.05,
                                             "kt_over_m": 1, "dt": "1/960"}),
    "20_box_stack": (stack, {"masses": [1] * 15, "g": G, "heights": [1] * 15, "target": 0.01}),
    "21_mass_ratio_100": (stack, {"masses": [1, 100], "g": G, "heights": [1, 1], "target": 0.01}),
    "21_mass_ratio_1000": (stack, {"masses": [1, 1000], "g": G, "heights": [1, 1],
                                   "target": 0.01}),
    "22_ball_and_chain": (ball_and_chain, {"links": 40, "link_mass": 1, "link_length": 0.25,
                                           "ball_mass": 672, "g": G, "target": 0.01}),
    "23_tunnelling": (tunnelling, {"r": 0.1, "wall": 0.1, "dt": "1/60",
                                   "speeds": [5, 9, 12, 18, 30, 60, 100, 300]}),
    "24_ragdoll_fall": (free_fall_group, {"mass": 60, "com": [0, 4, 0], "v": [0, 0, 0],
                                          "spin_momentum": [0, 0, 0], "g": G, "t": 0.5}),
}


def build(cases):
    """Every case as {"function", "params", "exact"}, ready for JSON."""
    return {key: {"function": fn.__name__, "params": plain(params), "exact": plain(fn(**params))}
            for key, (fn, params) in cases.items()}


def write(cases, path):
    """Write the cases to a JSON file, nearest f64 of each exact value."""
    path.write_text(json.dumps(build(cases), indent=1) + "\n")


if __name__ == "__main__":
    write(CASES, Path(__file__).with_name("exact.json"))
