# %% [markdown]
# # gyrospec in a notebook
# Each `# %%` is a cell in Jupyter, VS Code and Spyder; as a script it runs from top to bottom.

# %%
from __future__ import annotations

import gyrospec
import numpy as np

# %% [markdown]
# ## The variance behind a filter
# White noise of unit intensity through C/H with C = 2 and H = s² + 2s + 3.

# %%
answer = gyrospec.integral([1, 2, 3], c=[2])
print(answer)

# %% [markdown]
# The same for 100 000 filters at once: a row is a filter, and no array is copied.

# %%
damping = np.linspace(0.01, 2.0, 100_000)
h = np.column_stack([np.ones_like(damping), damping, np.full_like(damping, 3.0)])
g = np.tile([0.0, 4.0], (len(damping), 1))
many = gyrospec.integral_batch(h, g)
print(many, "largest", many.value.max())
assert np.allclose(many.value, 4 / (2 * damping * 3))

# %% [markdown]
# ## A model and a recording
# A turntable that is braked by its bearing. We make the recording ourselves, with a dry friction that
# the model does not know.

# %%
MODEL = """
name = "turntable"
[inputs]
torque = { unit = "N*m", meaning = "of the motor" }
[parameters]
J = { value = 1.0, unit = "kg*m^2", fit = true, min = 0.01, max = 100.0 }
D = { value = 0.2, unit = "N*m*s", fit = true, min = 0.0, max = 100.0 }
[states]
w = { rate = "(torque - D*w)/J", unit = "rad/s", initial = 0.0 }
[outputs]
rate = { equals = "w", unit = "deg/s" }
"""

rng = np.random.default_rng(1)
step = 0.1
time = step * np.arange(300)
torque = 2.0 * np.sin(0.9 * time) + 1.2 * np.sin(2.3 * time) + 0.3 * rng.standard_normal(len(time))
rate, fine = [0.0], 200
for k in range(len(time) - 1):
    w = rate[-1]
    for i in range(fine):
        m = torque[k] + (torque[k + 1] - torque[k]) * (i + 0.5) / fine
        # braked by 0.4 N·m of dry friction besides the viscous 0.3 N·m·s
        w += step / fine * (m - 0.3 * w - 0.4 * np.tanh(w / 1e-3)) / 1.2
    rate.append(float(w))
columns = {"t": time, "torque": torque, "rate": np.degrees(rate) + 0.05 * rng.standard_normal(len(time))}

# %% [markdown]
# Columns of a dict, of a pandas or of a Polars frame: say their units, nothing is guessed.

# %%
recording = gyrospec.recording(columns, units={"t": "s", "torque": "N*m", "rate": "deg/s"}, name="turntable")
print(recording)

# %%
fitted = gyrospec.fit(MODEL, recording)
for p in fitted.parameters:
    print(f"{p.name} = {p.value:.3f} {p.unit}  [{p.low:.3f}, {p.high:.3f}]")

# %% [markdown]
# The best of this model is not good. What does it leave out? In a notebook the last line of the cell
# shows the whole report with its pictures.

# %%
diagnosis = gyrospec.diagnose(MODEL, recording)
print(diagnosis.verdict, [f.code for f in diagnosis.findings])
print(diagnosis.says)
diagnosis  # noqa: B018

# %%
better = gyrospec.simulate(diagnosis.model_out, recording)["rate"]
before = gyrospec.simulate(fitted.model_out, recording)["rate"]
print(f"rms error {before.rms_error:.2f} deg/s before, {better.rms_error:.2f} after")

# %% [markdown]
# ## The rolling error of a gyrocompass
# By heading, in an irregular roll of 4° with decay 0.06 1/s and frequency 0.65 rad/s, at 60° north.

# %%
error = gyrospec.roll_error(irregular=("4deg", 0.06, 0.65), latitude=60)
for heading, mean, spread in zip(
    *(error.column(c) for c in ("heading_deg", "mean_deg", "spread_deg")), strict=True
):
    if heading % 45 == 0:
        print(f"{heading:5.0f}°  {mean:8.4f}° ± {spread:.4f}°")

# %% [markdown]
# A sweep: where is the error largest, over a million compasses and rolls?

# %%
lag = np.linspace(0.05, 2.0, 1000)[:, None]
frequency = np.linspace(0.3, 1.5, 1000)[None, :]
sweep = gyrospec.roll_error_sweep(T=lag, eps=frequency, A=np.radians(2) ** 2)
worst = np.unravel_index(np.nanargmax(np.abs(sweep)), sweep.shape)
print(
    f"largest: {np.degrees(sweep[worst]):.2f}° at T = {lag[worst[0], 0]:.2f} s, "
    f"eps = {frequency[0, worst[1]]:.2f} rad/s"
)
