#!/usr/bin/python3
"""Writes analytic/*.csv, gravity/*.csv and us76/us76_{exact,layers}.csv from the closed forms, with 40 digits (Debian: python3-mpmath).

The columns are those that `physim validate` reads. z and "up" are vertical here; y is up in PhySim.
"""
from pathlib import Path

from mpmath import (acos, acosh, asinh, atan, atan2, cos, ei, exp, findroot, lambertw, log, mp, mpf, pi, quad, radians,
                    sin, sqrt, tan, tanh)

mp.dps = 40
HERE = Path(__file__).parent
G = mpf("9.80665")
GM = mpf("3.986004418e14")
R = mpf(6371000)


def text(value):
    return value if isinstance(value, str) else mp.nstr(value, 20)


def write(path, comment, header, rows):
    lines = [f"# {comment}", "# Made by data/validation/make.py.", header] + [",".join(map(text, row)) for row in rows]
    (HERE / path).write_text("\n".join(lines) + "\n")


# ------------------------------------------------------------------------------------------------------- flat ground
def vacuum_parabola():
    rows = []
    for v0, elev in [(10, 45), (50, 20), (250, 60), (300, 15), (900, 40), (1000, 75)]:
        s, c = sin(radians(mpf(elev))), cos(radians(mpf(elev)))
        t = 2 * v0 * s / G
        rows.append((str(v0), str(elev), t, v0 * c * t, (v0 * s) ** 2 / (2 * G)))
    write("analytic/vacuum_parabola.csv", "Source: Galilei 1638: x = v0 cos t, z = v0 sin t - g t^2 / 2, g=9.80665.",
          "v0_m_s,elev_deg,t_flight_s,range_m,apex_m", rows)


def linear_drag():
    rows = []
    for v0, elev, k, w in [("100", "45", "0.1", "0"), ("60", "35", "0.4", "0"), ("400", "50", "0.02", "12"),
                           ("20", "80", "3", "-4"), ("50", "60", "1", "0")]:
        vx, vz = mpf(v0) * cos(radians(mpf(elev))), mpf(v0) * sin(radians(mpf(elev)))
        kk, ww = mpf(k), mpf(w)

        def state(t):
            e = exp(-kk * t)
            up = vz + G / kk
            return (ww * t + (vx - ww) * (1 - e) / kk, up * (1 - e) / kk - G * t / kk, ww + (vx - ww) * e, up * e - G / kk)

        a = 1 + kk * vz / G
        t = ((a + lambertw(-a * exp(-a))) / kk).real
        apex = log(a) / kk
        end, half = state(t), state(t / 2)
        rows.append((v0, elev, k, w, t, end[0], apex, state(apex)[1], half[0], half[1], end[2], end[3]))
    write("analytic/linear_drag.csv",
          "Source: Lambert 1765 in the form of Packel and Yuen 2004: k T = A + W0(-A exp(-A)), A = 1 + k vz0 / g, of "
          "v' = g - k (v - w), g=9.80665.",
          "v0_m_s,elev_deg,k_1_s,wind_x_m_s,t_flight_s,range_m,t_apex_s,apex_m,x_half_m,z_half_m,vx_impact,vz_impact", rows)


def quadratic_vertical():
    rows = []
    for vt, t in [("10", "0.5"), ("10", "60"), ("54", "5"), ("85", "7"), ("300", "20")]:
        v, x = mpf(vt), mpf(t) * G / mpf(vt)
        log_cosh = x + log((1 + exp(-2 * x)) / 2)
        rows.append(("fall", vt, "0", t, v * tanh(x), v * v / G * log_cosh))
    for vt, v0 in [("54", "50"), ("85", "150"), ("300", "800")]:
        v, ratio = mpf(vt), mpf(v0) / mpf(vt)
        up, height = v / G * atan(ratio), v * v / (2 * G) * log(1 + ratio**2)
        rows.append(("ascent_apex", vt, v0, up, "0", height))
        down = v / G * acosh(exp(G * height / v**2))
        rows.append(("ascent_and_fall", vt, v0, up + down, mpf(v0) / sqrt(1 + ratio**2), ""))
    write("analytic/quadratic_vertical.csv",
          "Source: Newton 1687, book II sec. 2: v' = -g (1 +- (v / vt)^2); tanh and ln cosh in the fall, atan in the "
          "ascent; g=9.80665.", "case,vt_m_s,v0_up_m_s,t_s,speed_m_s,distance_fallen_or_height_m", rows)


def quadratic_2d():
    mp.dps = 25
    rows = []
    for v0, elev, k in [("50", "45", "0.005"), ("120", "40", "0.006"), ("850", "2", "0.0007"), ("400", "60", "0.0004")]:
        p0, vx0, kk = tan(radians(mpf(elev))), mpf(v0) * cos(radians(mpf(elev))), mpf(k)

        def f(p):
            return p * sqrt(1 + p * p) + asinh(p)

        def vx(p):
            return 1 / sqrt(1 / vx0**2 + kk / G * (f(p0) - f(p)))

        def z(p1):
            return quad(lambda p: p * vx(p) ** 2 / G, [p1, 0, p0])

        p1 = findroot(z, (-p0 * 1.1, -p0 * 1.6))
        t, x = (lambda a: quad(lambda p: vx(p) / G, [a, p0])), (lambda a: quad(lambda p: vx(p) ** 2 / G, [a, p0]))
        rows.append((v0, elev, k, t(0), x(0), quad(lambda p: p * vx(p) ** 2 / G, [0, p0]), t(p1), x(p1), vx(p1), p1 * vx(p1),
                     atan(p1) * 180 / pi))
    mp.dps = 40
    write("analytic/quadratic_2d_constant_density.csv",
          "Source: Bernoulli 1719, the hodograph of v' = g - k |v| v: 1 / vx^2 = 1 / vx0^2 + (k / g) (F(p0) - F(p)), "
          "F(p) = p sqrt(1 + p^2) + asinh p, p = tan(path angle), by quadrature; g=9.80665.",
          "v0_m_s,elev_deg,k_1_m,t_apex_s,x_apex_m,z_apex_m,t_impact_s,range_m,vx_impact,vz_impact,impact_angle_deg", rows)


def fall_exponential():
    rows = []
    for k0, h, start, stop in [("0.001", "8500", "30000", "15000"), ("0.0003", "7640", "25000", "20000"),
                               ("0.0003", "7640", "25000", "1000"), ("0.002", "8000", "35000", "5000")]:
        u = [2 * mpf(k0) * mpf(h) * exp(-mpf(place) / mpf(h)) for place in (start, stop)]
        rows.append((k0, h, start, stop, sqrt(exp(-u[1]) * 2 * G * mpf(h) * (ei(u[1]) - ei(u[0])))))
    write("analytic/fall_exponential_atmosphere.csv",
          "Source: the linear equation for v^2 of a fall with drag k0 exp(-z / H) v^2: v^2 = exp(-u) 2 g H (Ei(u) - "
          "Ei(u0)), u = 2 k0 H exp(-z / H), g=9.80665.", "k0_1_m,scale_height_m,z_start_m,z_m,speed_m_s", rows)


def bouncing_ball():
    rows, height = [], mpf(5)
    for e in ["0.6", "0.85"]:
        r, t, v = mpf(e), sqrt(2 * height / G), sqrt(2 * G * height)
        for bounce in range(6):
            rows.append((e, str(bounce), t, v))
            v *= r
            t += 2 * v / G
        rows.append((e, "inf", sqrt(2 * height / G) * (1 + r) / (1 - r), "0"))
    write("analytic/bouncing_ball.csv", "Source: a geometric series. Ball dropped from 5 m, restitution e, g=9.80665; the "
          "last row of each is its limit, sqrt(2 h / g) (1 + e) / (1 - e).",
          "restitution,bounce_index,t_contact_s,speed_before_contact_m_s", rows)


# -------------------------------------------------------------------------------------------------- turning and round
def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def turning(kappa, g, v0, t):
    """Position and velocity of v' = g + kappa x v, from the origin."""
    k = sqrt(sum(c * c for c in kappa))
    n = [c / k for c in kappa]

    def parts(a):
        along = [sum(x * y for x, y in zip(n, a)) * c for c in n]
        return along, [x - y for x, y in zip(a, along)], cross(n, a)

    s, c = sin(k * t), cos(k * t)
    (va, vp, vn), (ga, gp, gn) = parts(v0), parts(g)
    x = [va[i] * t + vp[i] * s / k + vn[i] * (1 - c) / k + ga[i] * t * t / 2 + gp[i] * (1 - c) / k**2
         + gn[i] * (t / k - s / k**2) for i in range(3)]
    v = [va[i] + vp[i] * c + vn[i] * s + ga[i] * t + gp[i] * s / k + gn[i] * (1 - c) / k for i in range(3)]
    return x, v


def coriolis():
    rows, w = [], mpf("7.292115e-5")
    for case, lat, v0, elev, az in [("drop", 45, 1000, 0, 0), ("drop", -30, 400, 0, 0), ("shot", 45, 800, 2, 90),
                                    ("shot", 60, 450, 40, 215), ("shot", -35, 900, 30, 340)]:
        phi, e, a = (radians(mpf(d)) for d in (lat, elev, az))
        kappa = [0, -2 * w * cos(phi), -2 * w * sin(phi)]  # east, north, up
        v = [0, 0, 0] if case == "drop" else [v0 * cos(e) * sin(a), v0 * cos(e) * cos(a), v0 * sin(e)]
        down = -v0 if case == "drop" else 0
        guess = sqrt(2 * mpf(v0) / G) if case == "drop" else 2 * v0 * sin(e) / G
        t = findroot(lambda s: turning(kappa, [0, 0, -G], v, s)[0][2] - down, guess)
        x, _ = turning(kappa, [0, 0, -G], v, t)
        rows.append((case, str(lat), str(v0), str(elev), str(az), t, *x))
    write("analytic/coriolis_uniform_g.csv",
          "Source: Rodrigues 1840 applied to v' = g - 2 Omega x v, flat, uniform g=9.80665, Omega 7.292115e-5 rad/s.",
          "case,lat_deg,h_m_or_v0,elev_deg,az_deg,t_s,east_m,north_m,up_m", rows)


def magnus():
    rows = []
    for kappa in [("0.5", "0", "0"), ("0", "-1", "0"), ("0", "0", "0.7"), ("0.3", "0.4", "1.2"), ("-0.2", "0.9", "-0.4")]:
        for t in ["0.5", "3"]:
            x, v = turning([mpf(c) for c in kappa], [0, 0, -G], [25, 5, 15], mpf(t))
            rows.append((*kappa, t, *x, *v))
    write("analytic/magnus_constant_kappa.csv", "Source: as coriolis_uniform_g.csv: v' = g + kappa x v, a Magnus force of "
          "constant spin, v0=(25,5,15), g=9.80665 along -z.", "kx_1_s,ky_1_s,kz_1_s,t_s,x_m,y_m,z_m,vx,vy,vz", rows)


def kepler():
    rows = []
    for a, e in [("6778137", "0"), ("7100000", "0.03"), ("26600000", "0.74"), ("12000000", "0.4")]:
        am, em = mpf(a), mpf(e)
        n = sqrt(GM / am**3)
        for part in ["0", "0.1", "0.35", "0.5", "0.8", "1"]:
            mean = 2 * pi * mpf(part)
            ecc = findroot(lambda q: q - em * sin(q) - mean, mean)
            rate, b = n / (1 - em * cos(ecc)), sqrt(1 - em**2)
            rows.append((a, e, mean / n, am * (cos(ecc) - em), am * b * sin(ecc), -am * sin(ecc) * rate, am * b * cos(ecc) * rate))
    write("analytic/kepler_orbits.csv", "Source: Kepler 1609, Newton 1687: two bodies, GM=3.986004418e14, periapsis on +x "
          "at t = 0; the last row of each orbit is one period later.", "a_m,e,t_s,x_m,y_m,vx_m_s,vy_m_s", rows)


def newton_range():
    rows = []
    for v0, elev in [(300, 45), (1600, 45), (2500, 55), (3000, 30), (6000, 35)]:
        v, th = mpf(v0), radians(mpf(elev))
        a = 1 / (2 / R - v**2 / GM)
        p = (R * v * cos(th)) ** 2 / GM
        e = sqrt(1 - p / a)
        nu = acos((p / R - 1) / e)  # launch, ascending
        ecc = 2 * atan(sqrt((1 - e) / (1 + e)) * tan(nu / 2))
        rows.append((str(v0), str(elev), 2 * (pi - nu) * R, a * (1 + e) - R, 2 * (pi - ecc + e * sin(ecc)) / sqrt(GM / a**3)))
    write("analytic/newton_gravity_range.csv", "Source: the ellipse of Newton 1687 cut by a sphere, R=6371000, "
          "GM=3.986004418e14, no air, not rotating.", "v0_m_s,elev_deg,ground_range_m,apex_height_m,t_flight_s", rows)


def radial_fall():
    rows = []
    for h in [1000, 50000, 400000, 6371000]:
        r0 = R + h
        x = R / r0
        rows.append((str(h), sqrt(r0**3 / (2 * GM)) * (sqrt(x * (1 - x)) + acos(sqrt(x))), sqrt(2 * GM * (1 / R - 1 / r0))))
    write("analytic/radial_fall_newton.csv", "Source: Newton 1687: fall from rest at height h above R=6371000, "
          "GM=3.986004418e14.", "h_m,t_s,v_impact_m_s", rows)


# ---------------------------------------------------------------------------------------------------- the atmosphere
def us76():
    r0, gas, molar, gamma = mpf(6356766), mpf("8314.32"), mpf("28.9644"), mpf("1.4")
    bases = [(0, "-0.0065"), (11000, "0"), (20000, "0.001"), (32000, "0.0028"), (47000, "0"), (51000, "-0.0028"),
             (71000, "-0.002"), (84852, "")]
    layers, t, p = [], mpf("288.15"), mpf(101325)
    for i, (h, lapse) in enumerate(bases):
        layers.append((h, mpf(lapse or 0), t, p, lapse))
        if i + 1 < len(bases):
            t, p = step(layers[-1], mpf(bases[i + 1][0]), gas, molar)
    write("us76/us76_layers.csv", "Source: U.S. Standard Atmosphere, 1976 (NOAA-S/T 76-1562), table 4: bases of the layers.",
          "layer,H_base_m,Z_base_m,T_base_K,P_base_Pa,lapse_K_per_m",
          [(str(i), str(h), r0 * h / (r0 - h), t, p, lapse) for i, (h, _, t, p, lapse) in enumerate(layers)])
    rows = []
    for z in [-5000, -1500, 0, 500, 1000, 3300, 7500, 11019, 11020, 13500, 20063, 20064, 25000, 32161, 32162, 41000, 47350,
              47351, 51412, 51413, 60000, 71801, 71802, 79000, 85000]:
        h = r0 * z / (r0 + z)
        t, p = step([layer for layer in layers if layer[0] <= h or layer[0] == 0][-1], h, gas, molar)
        rows.append((str(z), h, t, p, p * molar / (gas * t), sqrt(gamma * gas * t / molar),
                     mpf("1.458e-6") * t**1.5 / (t + mpf("110.4")), G * (r0 / (r0 + z)) ** 2))
    write("us76/us76_exact.csv", "Source: U.S. Standard Atmosphere, 1976 (NOAA-S/T 76-1562), eq. 17, 18, 23, 33a, 33b, 42, "
          "50, 51: molecular temperature, r0 = 6356766 m, R* = 8314.32 J/(kmol K), M0 = 28.9644 kg/kmol.",
          "Z_geometric_m,H_geopotential_m,T_molecular_K,P_Pa,rho_kg_m3,a_m_s,mu_Pa_s,g_m_s2", rows)


def step(layer, h, gas, molar):
    base, lapse, t, p, _ = layer
    if lapse == 0:
        return t, p * exp(-G * molar * (h - base) / (gas * t))
    above = t + lapse * (h - base)
    return above, p * (t / above) ** (G * molar / (gas * lapse))


# -------------------------------------------------------------------------------------------------------- gravity
def gravity():
    a, f, w = mpf(6378137), 1 / mpf("298.257223563"), mpf("7.292115e-5")
    j2 = mpf("1.08262982e-3")
    e2, b = f * (2 - f), a * (1 - f)
    lin = sqrt(a * a - b * b)  # linear eccentricity

    def q(u):
        return ((1 + 3 * u * u / lin**2) * atan(lin / u) - 3 * u / lin) / 2

    def q_slope(u):
        return 3 * (1 + u * u / lin**2) * (1 - u / lin * atan(lin / u)) - 1

    def normal(p, z):
        s = p * p + z * z - lin**2
        u = sqrt((s + sqrt(s * s + 4 * lin**2 * z * z)) / 2)
        v, beta = sqrt(u * u + lin**2), atan2(z * sqrt(u * u + lin**2), u * p)
        size = sqrt((u * u + (lin * sin(beta)) ** 2) / (u * u + lin**2))
        turn = (w * a) ** 2
        g_u = -(GM / v**2 + turn * lin / v**2 * q_slope(u) / q(b) * (sin(beta) ** 2 / 2 - mpf(1) / 6)) / size
        g_u += w * w * u * cos(beta) ** 2 / size
        g_beta = (turn / v * q(u) / q(b) - w * w * v) * sin(beta) * cos(beta) / size
        return (u / (size * v) * cos(beta) * g_u - sin(beta) / size * g_beta,
                sin(beta) / size * g_u + u / (size * v) * cos(beta) * g_beta)

    def flattened(p, z):
        r = sqrt(p * p + z * z)
        c, s2 = mpf(3) / 2 * j2 * (a / r) ** 2, (z / r) ** 2
        return (-GM * p / r**3 * (1 - c * (5 * s2 - 1)) + w * w * p, -GM * z / r**3 * (1 - c * (5 * s2 - 3)))

    rows = []
    for lat in [-90, -63, -30, -5, 0, 12, 37, 45, 52, 71, 90]:
        for h in [-2000, 0, 3000, 12000, 86000, 400000, 35786000]:
            phi = radians(mpf(lat))
            n = a / sqrt(1 - e2 * sin(phi) ** 2)
            place = ((n + h) * cos(phi), (n * (1 - e2) + h) * sin(phi))
            row = [str(lat), str(h)]
            for field in (normal, flattened):
                g_p, g_z = field(*place)
                row += [g_p * cos(phi) + g_z * sin(phi), g_z * cos(phi) - g_p * sin(phi)]
            rows.append(row)
    write("gravity/wgs84_normal_gravity.csv", "Source: W. A. Heiskanen and H. Moritz, Physical Geodesy (1967), eq. 2-56 to "
          "2-67, with the constants of WGS-84 (NIMA TR8350.2, 2000): gravitation and centrifugal acceleration by geodetic "
          "latitude and height above the ellipsoid, up and north. J2: point mass and J2 = 1.08262982e-3 instead.",
          "lat_deg,h_m,gamma_up,gamma_north,J2_up,J2_north", rows)


if __name__ == "__main__":
    for make in (vacuum_parabola, linear_drag, quadratic_vertical, quadratic_2d, fall_exponential, bouncing_ball, coriolis,
                 magnus, kepler, newton_range, radial_fall, us76, gravity):
        make()
