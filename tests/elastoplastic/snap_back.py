#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Softening layer (benchmark C2) with a third of its internal length: its
load-displacement curve goes back, displacement control ends there, and control
by a measured opening leads along it. Newton's method with the load factor as an
unknown is quadratic."""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings

check = Check(__doc__)

WIDTH, SMALL, U_END = 2.5, 1e-3, 5.0  # of the scene; U [mm] at s = 1

LAYER = element_settings("Q2/Q1 full") + [
    "Grid/Cells=1, 80",
    "Materials/solid/Bending modulus=32000",  # 2 mu L^2, L = 2
    "Loading/Stop=0.6",
    # the whole middle yields at once: there a step is cut
    "Loading/Fixed steps=false", "Loading/Smallest step=1e-6"]
TRACTION = ["Boundary conditions/top/Displacement 1=",
            "Boundary conditions/top/Traction 1=0.2*s"]
STRESSES = [97 - i for i in range(33)]  # from the peak to well behind the turn


def opening(inner, outer):
    """Control by the opening of the zone between two heights [mm]."""
    return ["Loading/Control=opening",
            f"Loading/Opening/From=1.25, {inner}",
            f"Loading/Opening/To=1.25, {outer}",
            "Loading/Opening/Final opening=5e-3"]


def path(result):
    """Displacement of the top [mm] and shear stress, step by step."""
    history = result.history
    return ([1e3 * u for u in history["top u1 [m]"]],
            [f / WIDTH / SMALL for f in history["top force 1 [N/m]"]])


def displacements(result, stresses):
    """U [mm] at stresses after the peak, where the stress is what falls in
    every step; linear between steps."""
    u, tau = path(result)
    found = []
    for t in stresses:
        i = next(i for i in range(tau.index(max(tau)), len(tau) - 1)
                 if tau[i] >= t > tau[i + 1])
        found.append(u[i] + (u[i + 1] - u[i]) * (t - tau[i]) /
                     (tau[i + 1] - tau[i]))
    return found


def run(name, settings, **options):
    return check.run("layer.prm", name.replace(" ", "_"), LAYER + settings,
                     **options)


def without_step_size(name, settings, stresses, first=None, **options):
    """U from steps of 0.002 and 0.001, which have an error of first order,
    extrapolated to steps of size zero."""
    coarse = displacements(first or run(name, settings, **options), stresses)
    fine = displacements(
        run(name + " fine", settings + ["Loading/Initial step=0.001",
                                        "Loading/Largest step=0.001"],
            **options), stresses)
    return [2.0 * b - a for a, b in zip(coarse, fine)]


# The top goes back while the opening grows and the stress falls.
wide = run("opening", opening(20, 80))
history = wide.history
u, tau = path(wide)
turn = next(i for i in range(1, len(u)) if u[i + 1] < u[i])
back = next(i for i in range(turn, len(u) - 1) if u[i + 1] > u[i])
print(f"      {len(u) - 1} steps, {history['cuts [1]'][-1]:g} cuts")
check.note(u[back] < 0.985 * u[turn],
           f"the top goes back by more than 1.5 %: U = {u[turn]:.4f} mm at the "
           f"stress {tau[turn]:.2f}, {u[back]:.4f} mm at {tau[back]:.2f}")
check.note(all(b < a for a, b in zip(tau[turn:back], tau[turn + 1:back + 1])),
           "the stress falls in every step between")
check.fields("top and load factor", 1e-11,
             u=(u, [U_END * f for f in history["load factor [1]"]], U_END))
check.fields("opening", 1e-11,
             s=(history["opening [m]"],
                [5e-3 * s for s in history["load [1]"]], 5e-3))

# With half the internal length the curve is steep, but does not go back yet.
half, _ = path(run("half", opening(20, 80) +
                   ["Materials/solid/Bending modulus=72000"]))
check.note(all(b > a for a, b in zip(half, half[1:])),
           "L = 3: the top moves on in every step")

# The same path with a load instead of a displacement, on two ranks with one
# place each, and after a resumption; in all of them a step ends at s = 0.4.
marked = opening(20, 80) + ["Output/Fields every=0.4",
                            "Checkpoint/Every steps=50"]
traction = run("traction", marked + TRACTION)
at = displacements(traction, STRESSES)
check.fields("U at stresses 97 to 65, displacement on two ranks and traction",
             1e-8, U=(displacements(run("ranks", marked, ranks=2), STRESSES),
                      at, U_END))
run("resumed", marked + ["Loading/Stop=0.4"])
other = run("resumed", marked, overwrite=False, resume=True)
behind = [t for t in STRESSES
          if t < path(traction)[1][traction.history["load [1]"].index(0.4)]]
check.fields(f"U at stresses {behind[0]} to 65, resumed at s = .4", 1e-8,
             U=(displacements(other, behind), at[-len(behind):], U_END))

# The same whatever zone is measured, but for the size of steps.
at = without_step_size("opening", opening(20, 80), STRESSES, first=wide)
other = without_step_size("narrower", opening(30, 70), STRESSES)
check.fields("U at stresses 97 to 65, a narrower zone", 1e-4,
             U=(other, at, U_END))

# Displacement control finds the same path up to the turn and ends there.
before = [t for t in STRESSES if t >= 85]
plain = run("plain", [], expect=1)
end = path(plain)
check.note(abs(end[0][-1] - u[turn]) < 0.01 and end[1][-1] < tau[turn] + 3.0,
           f"displacement control ends at U = {end[0][-1]:.4f} mm, stress "
           f"{end[1][-1]:.2f}")
check.contains("it", plain.text, "cannot be solved: no balance")
other = without_step_size("plain", [], before, first=plain, expect=1)
check.fields("U at stresses 97 to 85, displacement control", 1e-4,
             U=(other, at[:len(before)], U_END))

# One step far into softening: the last residuals, of runs that give up earlier.
for name, settings in (("displacement", []), ("traction", TRACTION)):
    step = opening(20, 80) + settings + [
        "Materials/solid/Bending modulus=288000",
        "Materials/solid/Hardening modulus=-200",
        "Loading/Initial step=0.7", "Loading/Largest step=0.7",
        "Loading/Stop=0.7", "Loading/Fixed steps=true",
        "Solver/Target iterations=1", "Solver/Residual=1e-15"]
    n = int(run("newton", step).history["iterations [1]"][-1])
    residuals = []
    for most in range(n - 2, n):
        text = run("newton", step + [f"Solver/Most iterations={most}"],
                   expect=1).text
        residuals.append(max(map(float, re.search(
            r"forces (\S+), moments (\S+) of", text).groups())))
    check.note(residuals[0] < 1e-7 and
               residuals[1] < 1e5 * residuals[0] ** 2,
               f"last residuals of {n} iterations under a {name}: " +
               ", ".join(f"{r:.1e}" for r in residuals) + ", below 1e-15")

for settings, words in (
        (opening(20, 101), "Loading/Opening/To: the place (1.25 101) m is not"),
        (opening(20, 80) + ["Loading/Opening/Component=2"],
         "does not move the places From and To apart")):
    wrong = run("wrong", settings, expect=2)
    check.contains("the message", wrong.text, words)
check.finish()
