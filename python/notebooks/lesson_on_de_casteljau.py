# %% [markdown]
# # A lesson: de Casteljau's algorithm is blossoming
#
# The control points of a quadratic curve over [0, 1] are the blossom values p(0,0), p(0,1) and p(1,1). De Casteljau's
# algorithm replaces one argument after the other by t.

# %%
from fractions import Fraction

import blossom
from blossom import Bezier, delta

curve = Bezier([[0, 0], [1, 2], [3, 0]])
assert [curve[0, 0], curve[0, 1], curve[1, 1]] == list(curve.points)
curve

# %% [markdown]
# One step replaces an argument: p(0,t) lies between p(0,0) and p(0,1), at t of the way.

# %%
t = Fraction(1, 3)
left, right = curve[0, t], curve[t, 1]
assert left == tuple((1 - t) * a + t * b for a, b in zip(curve[0, 0], curve[0, 1]))
assert curve(t) == tuple((1 - t) * a + t * b for a, b in zip(left, right))

# %% [markdown]
# All levels, worked out:

# %%
curve.worked("evaluate", at=["1/3"])

# %%
print(curve.worked("evaluate", at=["1/3"], format="text"))

# %% [markdown]
# The same numbers are the control points of both halves.

# %%
first, second = curve.subdivide(t)
assert first.points == (curve[0, 0], curve[0, t], curve[t, t])
assert second.points == (curve[t, t], curve[t, 1], curve[1, 1])

# %% [markdown]
# A vector among the arguments differentiates: the derivative is twice p(t, delta).

# %%
assert curve.derivative(at=[t])[0] == tuple(2 * x for x in curve[t, delta])

# %% [markdown]
# ## Exercises
#
# A sheet for the class, and its solutions for the teacher:

# %%
print(blossom.exercise("subdivision", count=2, seed=7))

# %%
print(blossom.exercise("subdivision", count=2, seed=7, solutions=True))
