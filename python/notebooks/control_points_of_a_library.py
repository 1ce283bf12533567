# %% [markdown]
# # Control points of a library, made and audited
#
# A library converts a polynomial to Bezier form and refines its control polygon in doubles. This notebook makes the exact
# points, and says by how much those of the library are wrong.

# %%
from fractions import Fraction

import numpy
from scipy import interpolate

import blossom
from blossom import Map, Polynomial
from blossom.testing import assert_exact

# %% [markdown]
# ## The exact control points

# %%
curve = Polynomial(["t", "t^3 - 1/2t"]).control_points(interval=["1/10", "9/10"])
curve

# %% [markdown]
# What a file of doubles should contain:

# %%
blossom.array(curve.points)

# %% [markdown]
# ## What a library computes
#
# SciPy inserts a knot into a B-spline whose coefficients are doubles.

# %%
knots = numpy.array([0, 0, 0, 0, 1, 2, 3, 3, 3, 3], dtype=float)
coefficients = numpy.array([0.1, 0.7, -1.3, 0.2, 2.1, -0.4])
inserted = interpolate.insert(1.3, (knots, numpy.append(coefficients, numpy.zeros(4)), 3))

# %% [markdown]
# The exact spline has the values of these doubles, and so has the inserted knot.

# %%
exact = Map.from_scipy((knots, coefficients, 3)).insert_knots([Fraction(1.3)])
assert blossom.floats(exact.knots) == tuple(inserted[0])
audit = exact.audit(computed={"control_points": inserted[1][: len(exact.points)]})
print(audit)
assert audit.numbers == 7

# %% [markdown]
# The same as a test that fails with the worst coefficient:

# %%
assert_exact(inserted[1][: len(exact.points)], exact.points, ulps=8)

# %% [markdown]
# ## Values
#
# De Boor's algorithm in doubles, against the nearest doubles:

# %%
parameters = [Fraction(k, 32) for k in range(1, 96)]
spline = interpolate.BSpline(knots, coefficients, 3)
values = spline(blossom.floats(parameters))
report = Map.from_scipy(spline).audit(at=parameters, computed={"values": values})
print(f"{report.not_nearest} of {report.numbers} values are not the nearest double; the worst is "
      f"{float(report.greatest_ulps):.1f} ulps away")  # fmt: skip
