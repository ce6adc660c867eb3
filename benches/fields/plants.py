"""The fields."""

import numpy as np

from fields import LAW, ONE, Field, of, steps, swept


def codes(*names):
    return frozenset(names)


def axis(x, u, p):
    q, v = x
    bump = of(p, "magnet") * np.sin(q / 0.06) * np.exp(-((q / 0.15) ** 2))
    drag = 3.0 * v * (1 - of(p, "eddy") * (1 - 1 / (1 + (v / 0.25) ** 2)))
    law = of(p, "power") * np.sign(v) * abs(v) ** 1.5
    return [v, (u[0] - drag - 60 * q - of(p, "k3") * q**3 - bump - law) / 2.2]


AXIS = Field(
    "axis", "Den Hartog, Mechanical Vibrations (1956)", 0.02, 6000,
    {"force": ("N", swept(12.0))}, [0.0, 0.0], axis,
    {"position": ("m", lambda x, u, p: x[0] + of(p, "scale") * np.sin(x[0] / 0.08), 0.01)},
    """
name = "axis"
[inputs]
force = { unit = "N" }
[parameters]
M = { value = 2, unit = "kg", fit = true, min = 0.1 }
b = { value = 2, unit = "N*s/m", fit = true, min = 0 }
k = { value = 55, unit = "N/m", fit = true, min = 1 }
[states]
q = { rate = "v", unit = "m", initial = "fit" }
v = { rate = "(force - b*v - k*q)/M", unit = "m/s", initial = "fit" }
[outputs]
position = { equals = "q", unit = "m" }
""",
    {"null": ({}, ONE),
     "power": ({"power": 12.0}, codes("power-law", "quadratic-damping")),
     "stiffening": ({"k3": 250.0}, codes("cubic-stiffness")),
     "magnet": ({"magnet": 6.0}, LAW),
     "eddy": ({"eddy": 0.8}, LAW | codes("saturable-rate", "parameter-dependence")),
     "scale": ({"scale": 0.03}, LAW)},
)


def furnace(x, u, p):
    T, w = x[0], x[1] if len(x) > 1 else 0.0
    P, Ta = u[0], u[1]
    loss = 6.0 * (T - Ta) * (1 + of(p, "fan") * (u[2] - 1.0))
    rad = of(p, "rad") * 5.67e-8 * (T**4 - Ta**4)
    to_wall = of(p, "wall") * (T - w)
    door = of(p, "door") * 4000 / (1 + np.exp(-(T - 600) / 20))
    return [(P - loss - rad - to_wall - door) / 2500, to_wall / 9000]


FURNACE = Field(
    "furnace", "Incropera, DeWitt, Fundamentals of Heat and Mass Transfer (2006), ch. 1 and 5", 10.0, 3000,
    {"P": ("W", steps(500, 4500, 900)), "Ta": ("K", swept(4.0, 293.0, 8.0, 4))}, [450.0, 450.0], furnace,
    {"T_meas": ("K", lambda x, u, p: x[0], 0.005)},
    """
name = "furnace"
[inputs]
P = { unit = "W" }
Ta = { unit = "K" }
[parameters]
C = { value = 2000, unit = "J/K", fit = true, min = 10 }
h = { value = 8, unit = "W/K", fit = true, min = 0 }
[states]
T = { rate = "(P - h*(T - Ta))/C", unit = "K", initial = "fit" }
[outputs]
T_meas = { equals = "T", unit = "K" }
""",
    {"null": ({}, ONE),
     "radiation": ({"rad": 0.15}, codes("radiation")),
     "wall": ({"wall": 5.0}, codes("extra-lag", "memory")),
     "fan": ({"fan": 0.4}, codes("parameter-dependence")),
     "door": ({"door": 0.6}, LAW)},
    {"fan": ("1", swept(0.4, 1.0, 10.0, 6))},
)


def rooms(x, u, p):
    a, b = x
    P1, P2, Ta = u[0], u[1], u[2]
    through = of(p, "wall") * (a - b)
    sun = of(p, "sun") * u[3]
    rad = of(p, "draught") * np.sign(a - Ta) * abs(a - Ta) ** 1.5
    rad += of(p, "window") * (a - Ta) / (1 + np.exp(-(a - 300) / 0.5))
    return [(P1 - 40 * (a - Ta) - through + sun - rad) / 2e5, (P2 - 30 * (b - Ta) + through) / 3e5]


ROOMS = Field(
    "rooms", "Bacher, Madsen, Energy and Buildings 43 (2011) 1511", 120.0, 2500,
    {"P1": ("W", steps(0, 1500, 9000)), "P2": ("W", steps(0, 1200, 13000)), "Ta": ("K", swept(5.0, 278.0, 12.0, 4))},
    [290.0, 292.0], rooms,
    {"T1_meas": ("K", lambda x, u, p: x[0], 0.01), "T2_meas": ("K", lambda x, u, p: x[1], 0.01)},
    """
name = "rooms"
[inputs]
P1 = { unit = "W" }
P2 = { unit = "W" }
Ta = { unit = "K" }
[parameters]
C1 = { value = 1.5e5, unit = "J/K", fit = true, min = 1 }
C2 = { value = 2.5e5, unit = "J/K", fit = true, min = 1 }
h1 = { value = 50, unit = "W/K", fit = true, min = 0 }
h2 = { value = 35, unit = "W/K", fit = true, min = 0 }
[states]
T1 = { rate = "(P1 - h1*(T1 - Ta))/C1", unit = "K", initial = "fit" }
T2 = { rate = "(P2 - h2*(T2 - Ta))/C2", unit = "K", initial = "fit" }
[outputs]
T1_meas = { equals = "T1", unit = "K" }
T2_meas = { equals = "T2", unit = "K" }
""",
    {"null": ({}, ONE),
     "wall": ({"wall": 15.0}, codes("exchange")),
     "sun": ({"sun": 2.0}, codes("cross-coupling")),
     "window": ({"window": 30.0}, LAW),
     "draught": ({"draught": 4.0}, codes("power-law", "parameter-dependence"))},
    {"sun": ("W/m^2", steps(0, 400, 12000))},
)


def tanks(x, u, p):
    a, b = np.maximum(x, 1e-6)
    through = of(p, "pipe") * np.sign(a - b) * np.sqrt(abs(a - b))
    over = of(p, "over") * max(a - 1.05, 0.0)
    clog = 1 - of(p, "clog") * b
    weir = of(p, "weir") * max(a - 0.6, 0.0) ** 2.5
    return [(u[0] - 0.006 * a * clog - through - over - weir) / 0.5, (u[1] - 0.008 * b + through + over) / 0.4]


TANKS = Field(
    "tanks", "Bequette, Process Control (2003), ch. 2; Torricelli's law", 2.0, 4000,
    {"q1": ("m^3/s", steps(0.002, 0.01, 150)), "q2": ("m^3/s", steps(0.002, 0.008, 190))}, [0.8, 0.6], tanks,
    {"h1_meas": ("m", lambda x, u, p: x[0], 0.01), "h2_meas": ("m", lambda x, u, p: x[1], 0.01)},
    """
name = "tanks"
[inputs]
q1 = { unit = "m^3/s" }
q2 = { unit = "m^3/s" }
[parameters]
A1 = { value = 0.4, unit = "m^2", fit = true, min = 0.01 }
A2 = { value = 0.5, unit = "m^2", fit = true, min = 0.01 }
k1 = { value = 0.005, unit = "m^2/s", fit = true, min = 0 }
k2 = { value = 0.01, unit = "m^2/s", fit = true, min = 0 }
[states]
h1 = { rate = "(q1 - k1*h1)/A1", unit = "m", initial = "fit" }
h2 = { rate = "(q2 - k2*h2)/A2", unit = "m", initial = "fit" }
[outputs]
h1_meas = { equals = "h1", unit = "m" }
h2_meas = { equals = "h2", unit = "m" }
""",
    {"null": ({}, ONE),
     "pipe": ({"pipe": 0.002}, codes("exchange")),
     "overflow": ({"over": 0.02}, codes("overflow", "exchange")),
     "weir": ({"weir": 0.02}, LAW | codes("overflow", "power-law", "parameter-dependence")),
     "clog": ({"clog": 0.25}, codes("parameter-dependence", "product-coupling"))},
)


def reactor(x, u, p):
    X, S = np.maximum(x, 0)
    growth = 0.30 * S / (1 + S / of(p, "K", 1e9) + S**2 / of(p, "KK", 1e9)) * X
    death = of(p, "death") * X
    kept = of(p, "upkeep") * X * S / (S + 0.01)
    return [growth - u[0] * X - death, u[0] * (u[1] - S) - growth / 0.5 - kept]


REACTOR = Field(
    "reactor", "Bailey, Ollis, Biochemical Engineering Fundamentals (1986), ch. 7; Andrews (1968)", 0.1, 4000,
    {"D": ("1/s", swept(0.05, 0.2, 15.0, 6)), "Sin": ("kg/m^3", steps(1.5, 5.0, 25.0))}, [1.0, 0.6], reactor,
    {"X_meas": ("kg/m^3", lambda x, u, p: x[0], 0.01), "S_meas": ("kg/m^3", lambda x, u, p: x[1], 0.01)},
    """
name = "reactor"
[inputs]
D = { unit = "1/s" }
Sin = { unit = "kg/m^3" }
[parameters]
mu = { value = 0.2, unit = "m^3/(kg*s)", fit = true, min = 0 }
Y = { value = 0.4, unit = "1", fit = true, min = 0.01 }
[states]
X = { rate = "mu*S*X - D*X", unit = "kg/m^3", initial = "fit" }
S = { rate = "D*(Sin - S) - mu*S*X/Y", unit = "kg/m^3", initial = "fit" }
[outputs]
X_meas = { equals = "X", unit = "kg/m^3" }
S_meas = { equals = "S", unit = "kg/m^3" }
""",
    {"null": ({}, ONE),
     "monod": ({"K": 1.0}, codes("saturable-rate", "parameter-dependence")),
     "haldane": ({"K": 2.0, "KK": 1.0}, codes("saturable-rate")),
     "death": ({"death": 0.03}, codes("linear-damping")),
     "upkeep": ({"upkeep": 0.03}, codes("cross-coupling"))},
)


def drug(x, u, p):
    c, d = np.maximum(x, 0)
    out = 0.5 * c / (1 + c / of(p, "K", 1e9))
    between = of(p, "deep") * (c - d)
    return [u[0] - out - between, between * 0.5]


DRUG = Field(
    "drug", "Gibaldi, Perrier, Pharmacokinetics (1982), ch. 1, 2, 7", 0.05, 3000,
    {"dose": ("kg/(m^3*s)", steps(0.0, 2.0, 6.0))}, [0.5, 0.5], drug,
    {"c_meas": ("kg/m^3", lambda x, u, p: x[0], 0.01)},
    """
name = "drug"
[inputs]
dose = { unit = "kg/(m^3*s)" }
[parameters]
g = { value = 0.8, unit = "1", fit = true, min = 0.01 }
ke = { value = 0.3, unit = "1/s", fit = true, min = 0 }
[states]
c = { rate = "g*dose - ke*c", unit = "kg/m^3", initial = "fit" }
[outputs]
c_meas = { equals = "c", unit = "kg/m^3" }
""",
    {"null": ({}, ONE),
     "michaelis": ({"K": 2.0}, codes("saturable-rate", "parameter-dependence")),
     "deep": ({"deep": 0.4}, codes("extra-lag", "memory"))},
)


def speaker(x, u, p):
    q, v, i = x
    bl = 5.0 * (1 - of(p, "bl") * (q / 1e-3) ** 2)
    L = 0.5e-3 / (1 + of(p, "sat") * (i / 2.0) ** 2)
    k = 2000.0 * (1 + of(p, "k") * (q / 1e-3) ** 2)
    return [v, (bl * i - 1.2 * v - k * q) / 0.012, (u[0] - 6.0 * i - bl * v) / L]


SPEAKER = Field(
    "speaker", "Klippel, J. Audio Eng. Soc. 54 (2006) 907", 1e-4, 8000,
    {"u": ("V", swept(9.0, 0.0, 60.0, 14))}, [0.0, 0.0, 0.0], speaker,
    {"x_meas": ("m", lambda x, u, p: x[0], 0.01), "i_meas": ("A", lambda x, u, p: x[2], 0.01)},
    """
name = "speaker"
[inputs]
u = { unit = "V" }
[parameters]
M = { value = 0.01, unit = "kg", fit = true, min = 1e-4 }
R = { value = 1, unit = "N*s/m", fit = true, min = 0 }
k = { value = 1500, unit = "N/m", fit = true, min = 1 }
Bl = { value = 4, unit = "N/A", fit = true, min = 0.1 }
Re = { value = 5, unit = "ohm", fit = true, min = 0.1 }
Le = { value = 4e-4, unit = "H", fit = true, min = 1e-5 }
[states]
x = { rate = "v", unit = "m", initial = 0 }
v = { rate = "(Bl*i - R*v - k*x)/M", unit = "m/s", initial = 0 }
i = { rate = "(u - Re*i - Bl*v)/Le", unit = "A", initial = 0 }
[outputs]
x_meas = { equals = "x", unit = "m" }
i_meas = { equals = "i", unit = "A" }
""",
    {"null": ({}, ONE),
     "inductance": ({"sat": 0.6}, codes("parameter-dependence")),
     "force-factor": ({"bl": 0.08}, codes("parameter-dependence")),
     "suspension": ({"k": 0.12}, codes("cubic-stiffness", "parameter-dependence"))},
)


def drone(x, u, p):
    a, b, c = x
    g = of(p, "gyro", 0.0)
    drag = of(p, "drag")
    return [(u[0] - 0.02 * a - g * 0.012 * b * c) / 0.02, (u[1] - 0.02 * b + g * 0.016 * a * c) / 0.025,
            (u[2] - 0.015 * c - drag * c * abs(c)) / 0.035]


DRONE = Field(
    "drone", "Goldstein, Classical Mechanics (1980), ch. 5: Euler's equations", 0.02, 6000,
    {"Mx": ("N*m", swept(0.06)), "My": ("N*m", swept(0.06)), "Mz": ("N*m", swept(0.08))}, [0.0, 0.0, 0.0], drone,
    {"p_meas": ("rad/s", lambda x, u, p: x[0], 0.01), "q_meas": ("rad/s", lambda x, u, p: x[1], 0.01),
     "r_meas": ("rad/s", lambda x, u, p: x[2], 0.01)},
    """
name = "drone"
[inputs]
Mx = { unit = "N*m" }
My = { unit = "N*m" }
Mz = { unit = "N*m" }
[parameters]
Ix = { value = 0.015, unit = "kg*m^2", fit = true, min = 1e-4 }
Iy = { value = 0.03, unit = "kg*m^2", fit = true, min = 1e-4 }
Iz = { value = 0.03, unit = "kg*m^2", fit = true, min = 1e-4 }
d1 = { value = 0.01, unit = "N*m*s", fit = true, min = 0 }
d2 = { value = 0.01, unit = "N*m*s", fit = true, min = 0 }
d3 = { value = 0.01, unit = "N*m*s", fit = true, min = 0 }
[states]
p = { rate = "(Mx - d1*p)/Ix", unit = "rad/s", initial = "fit" }
q = { rate = "(My - d2*q)/Iy", unit = "rad/s", initial = "fit" }
r = { rate = "(Mz - d3*r)/Iz", unit = "rad/s", initial = "fit" }
[outputs]
p_meas = { equals = "p", unit = "rad/s" }
q_meas = { equals = "q", unit = "rad/s" }
r_meas = { equals = "r", unit = "rad/s" }
""",
    {"null": ({}, ONE),
     "gyroscopic": ({"gyro": 1.0}, codes("product-coupling")),
     "drag": ({"drag": 0.01}, codes("quadratic-damping", "power-law"))},
)


def battery(x, u, p):
    soc, v1, v2 = x
    r1 = 0.02 * np.exp(-of(p, "warm") * (u[1] - 298) / 10)
    return [-u[0] / 3600, u[0] / 2000 - v1 / (r1 * 2000), (u[0] / 8000 - v2 / (0.03 * 8000)) * of(p, "slow")]


BATTERY = Field(
    "battery", "Plett, Battery Management Systems I (2015), ch. 2", 1.0, 4000,
    {"i": ("A", steps(-4.0, 5.0, 60.0))}, [0.7, 0.0, 0.0], battery,
    {"u_meas": ("V", lambda x, u, p: 3.3 + 0.7 * x[0] + of(p, "knee") * np.exp(-x[0] / 0.05) - 0.03 * u[0] - x[1] - x[2], 0.02)},
    """
name = "battery"
[inputs]
i = { unit = "A" }
[parameters]
E = { value = 3.2, unit = "V", fit = true }
a = { value = 0.8, unit = "V", fit = true }
Q = { value = 3600, unit = "A*s" }
R = { value = 0.02, unit = "ohm", fit = true, min = 0 }
R1 = { value = 0.03, unit = "ohm", fit = true, min = 1e-4 }
C1 = { value = 1500, unit = "F", fit = true, min = 1 }
[states]
s = { rate = "-i/Q", unit = "1", initial = 0.7 }
v1 = { rate = "i/C1 - v1/(R1*C1)", unit = "V", initial = 0 }
[outputs]
u_meas = { equals = "E + a*s - R*i - v1", unit = "V" }
""",
    {"null": ({}, ONE),
     "slow": ({"slow": 1.0}, codes("extra-lag", "memory")),
     "warm": ({"warm": 0.5}, codes("parameter-dependence"))},
    {"Tb": ("K", swept(8.0, 298.0, 10.0, 5))},
)


def algae(x, u, p):
    N = max(x[0], 0.0)
    return [0.8 * (1 - N / of(p, "K", 1e9)) * N - u[0] * N]


ALGAE = Field(
    "algae", "Murray, Mathematical Biology I (2002), ch. 1", 0.05, 4000,
    {"harvest": ("1/s", swept(0.25, 0.8, 20.0, 8))}, [0.8], algae,
    {"n_meas": ("1", lambda x, u, p: x[0], 0.01)},
    """
name = "algae"
[inputs]
harvest = { unit = "1/s" }
[parameters]
r = { value = 0.7, unit = "1/s", fit = true }
[states]
N = { rate = "r*N - harvest*N", unit = "1", initial = "fit" }
[outputs]
n_meas = { equals = "N", unit = "1" }
""",
    {"null": ({}, ONE),
     "crowding": ({"K": 5.0}, codes("parameter-dependence", "quadratic-stiffness", "quadratic-damping"))},
)


def cstr(x, u, p):
    c = max(x[0], 0.0)
    k = 0.05 * np.exp(of(p, "arrhenius") * (u[2] - 320) / 10) / (1 + of(p, "poison") * (c / 300) ** 2)
    rate = k * c + of(p, "second") * c**2
    return [u[0] * (u[1] - c) - rate]


CSTR = Field(
    "cstr", "Fogler, Elements of Chemical Reaction Engineering (2006), ch. 3 and 4", 1.0, 3000,
    {"q": ("1/s", swept(0.015, 0.06, 12.0, 6)), "cin": ("kg/m^3", steps(200.0, 1200.0, 60.0))}, [300.0], cstr,
    {"c_meas": ("kg/m^3", lambda x, u, p: x[0], 0.01)},
    """
name = "cstr"
[inputs]
q = { unit = "1/s" }
cin = { unit = "kg/m^3" }
[parameters]
k = { value = 0.03, unit = "1/s", fit = true, min = 0 }
[states]
c = { rate = "q*(cin - c) - k*c", unit = "kg/m^3", initial = "fit" }
[outputs]
c_meas = { equals = "c", unit = "kg/m^3" }
""",
    {"null": ({}, ONE),
     "arrhenius": ({"arrhenius": 0.6}, codes("parameter-dependence")),
     "poison": ({"poison": 1.0}, codes("saturable-rate", "parameter-dependence")),
     "second-order": ({"second": 1e-4}, codes("quadratic-stiffness", "quadratic-damping", "power-law", "parameter-dependence"))},
    {"Tr": ("K", swept(6.0, 320.0, 10.0, 6))},
)


def car(x, u, p):
    v = x[0]
    return [(u[0] - 25 * v - of(p, "air") * v * abs(v) - of(p, "rolling") * np.tanh(v / 0.01)
             - of(p, "slope") * 1200 * 9.81 * u[1]) / 1200]


CAR = Field(
    "car", "Guzzella, Sciarretta, Vehicle Propulsion Systems (2013), ch. 2", 0.2, 4000,
    {"F": ("N", steps(200.0, 2000.0, 40.0))}, [20.0], car,
    {"v_meas": ("m/s", lambda x, u, p: x[0], 0.01)},
    """
name = "car"
[inputs]
F = { unit = "N" }
[parameters]
m = { value = 1000, unit = "kg", fit = true, min = 10 }
c = { value = 30, unit = "N*s/m", fit = true, min = 0 }
[states]
v = { rate = "(F - c*v)/m", unit = "m/s", initial = "fit" }
[outputs]
v_meas = { equals = "v", unit = "m/s" }
""",
    {"null": ({}, ONE),
     "air": ({"air": 0.6}, codes("quadratic-damping", "power-law", "parameter-dependence")),
     "rolling": ({"rolling": 150.0}, codes("dry-friction", "constant-force")),
     "slope": ({"slope": 1.0}, codes("cross-coupling", "output-cross-axis"))},
    {"grade": ("1", swept(0.02, 0.0, 12.0, 6))},
)


def roll(x, u, p):
    a, w = x
    return [w, (u[0] - 0.05 * w - 0.6 * a + of(p, "k3") * a**3 - of(p, "b2") * w * abs(w)
                + of(p, "soft") * 0.3 * a * np.exp(-((a / 0.12) ** 2)))]


ROLL = Field(
    "roll", "Ikeda, Himeno, Tanaka (1978); ITTC roll damping", 0.2, 5000,
    {"slope": ("rad/s^2", swept(0.05, 0.0, 60.0, 14))}, [0.1, 0.0], roll,
    {"phi": ("rad", lambda x, u, p: x[0], 0.01)},
    """
name = "roll"
[inputs]
slope = { unit = "rad/s^2" }
[parameters]
g = { value = 0.9, unit = "1", fit = true, min = 0.01 }
n = { value = 0.08, unit = "1/s", fit = true, min = 0 }
w2 = { value = 0.5, unit = "1/s^2", fit = true, min = 0.001 }
[states]
a = { rate = "w", unit = "rad", initial = "fit" }
w = { rate = "g*slope - n*w - w2*a", unit = "rad/s", initial = "fit" }
[outputs]
phi = { equals = "a", unit = "rad" }
""",
    {"null": ({}, ONE),
     "bilge": ({"b2": 0.4}, codes("quadratic-damping", "power-law", "cubic-damping")),
     "stability": ({"k3": 0.2}, codes("cubic-stiffness")),
     "loll": ({"soft": 1.0}, LAW)},
)


def chambers(x, u, p):
    a, b = x
    leak = of(p, "leak") * (a - b)
    out = 1e5 * np.tanh((a - 1e5) / 1e5) if of(p, "choke") else a - 1e5
    return [(u[0] - 0.4 * out - leak) / 2.0, (u[1] - 0.5 * (b - 1e5) + leak) / 1.5]


CHAMBERS = Field(
    "chambers", "Beater, Pneumatic Drives (2007), ch. 3", 0.02, 4000,
    {"m1": ("Pa*m^3/s", swept(3e4, 4e4)), "m2": ("Pa*m^3/s", swept(3e4, 5e4))}, [2e5, 2e5], chambers,
    {"p1_meas": ("Pa", lambda x, u, p: x[0], 0.01), "p2_meas": ("Pa", lambda x, u, p: x[1], 0.01)},
    """
name = "chambers"
[inputs]
m1 = { unit = "Pa*m^3/s" }
m2 = { unit = "Pa*m^3/s" }
[parameters]
V1 = { value = 1.5, unit = "m^3", fit = true, min = 0.01 }
V2 = { value = 2, unit = "m^3", fit = true, min = 0.01 }
c1 = { value = 0.3, unit = "m^3/s", fit = true, min = 0 }
c2 = { value = 0.6, unit = "m^3/s", fit = true, min = 0 }
p0 = { value = 100000, unit = "Pa" }
[states]
p1 = { rate = "(m1 - c1*(p1 - p0))/V1", unit = "Pa", initial = "fit" }
p2 = { rate = "(m2 - c2*(p2 - p0))/V2", unit = "Pa", initial = "fit" }
[outputs]
p1_meas = { equals = "p1", unit = "Pa" }
p2_meas = { equals = "p2", unit = "Pa" }
""",
    {"null": ({}, ONE), "leak": ({"leak": 0.2}, codes("exchange")),
     "choke": ({"choke": 1.0}, LAW | codes("parameter-dependence", "power-law"))},
)


def pendulum(x, u, p):
    a, w = x
    eddy = 0.3 * w / (1 + of(p, "eddy") * w**2)
    return [w, u[0] - eddy - 9.0 * (np.sin(a) if of(p, "large") else a) - of(p, "couple") * u[1] * w]


PENDULUM = Field(
    "pendulum", "Goldstein, Classical Mechanics (1980), ch. 3", 0.02, 6000,
    {"M": ("rad/s^2", swept(2.5, 0.0, 60.0))}, [0.1, 0.0], pendulum,
    {"angle": ("rad", lambda x, u, p: x[0], 0.01)},
    """
name = "pendulum"
[inputs]
M = { unit = "rad/s^2" }
[parameters]
g = { value = 0.9, unit = "1", fit = true, min = 0.01 }
d = { value = 0.2, unit = "1/s", fit = true, min = 0 }
w2 = { value = 8, unit = "1/s^2", fit = true, min = 0.1 }
[states]
a = { rate = "w", unit = "rad", initial = "fit" }
w = { rate = "g*M - d*w - w2*a", unit = "rad/s", initial = "fit" }
[outputs]
angle = { equals = "a", unit = "rad" }
""",
    {"null": ({}, ONE),
     "brake": ({"eddy": 1.0}, LAW | codes("parameter-dependence", "saturable-rate")),
     "large": ({"large": 1.0}, codes("gravity-pendulum", "cubic-stiffness")),
     "current": ({"couple": 0.3}, codes("parameter-dependence", "product-coupling"))},
    {"current": ("A", swept(0.6, 1.0, 10.0, 6))},
)


ALL = [AXIS, FURNACE, ROOMS, TANKS, REACTOR, DRUG, SPEAKER, DRONE, BATTERY, ALGAE, CSTR, CAR, ROLL, CHAMBERS, PENDULUM]
