# %% [markdown]
# # Verifying the identities of a paper
#
# A paper on splines states identities between blossom values, derivatives and control points. This notebook decides a
# few, for all maps and all values of the variables, and refutes a misprint with a counterexample.

# %%
import sympy

import blossom
from blossom import Polynomial, delta

# %% [markdown]
# ## One map, every argument
#
# `agree` builds the blossom by three constructions and compares them as polynomials.

# %%
p = Polynomial("1 + 2t + 4t^2 - t^3")
proof = p.agree()
print(proof)
assert proof

# %% [markdown]
# The same as an expression of SymPy. It is symmetric, and the polynomial on the diagonal.

# %%
u, v, w, t = sympy.symbols("u v w t")
expression = p.blossom_to_sympy(u, v, w)
assert sympy.expand(expression.subs({u: v, v: u}, simultaneous=True) - expression) == 0
assert sympy.expand(expression.subs({u: t, v: t, w: t}) - p.to_sympy(t)) == 0
expression

# %% [markdown]
# ## Every map of a degree
#
# A statement of the identity language speaks of all maps. A derivative is n times the blossom at one unit vector.

# %%
derivative = blossom.prove(
    """
for n in 1..6
map p degree n
claim p'(t) == n * p[t{n-1}, delta]
"""
)
print(derivative.verdict, "in", derivative.cases, "cases")
assert derivative

# %% [markdown]
# Numbers say the same of one map.

# %%
assert p.derivative(at=["5/7"])[0] == 3 * p["5/7", "5/7", delta]

# %% [markdown]
# ## A misprint
#
# Where the point 1 is printed for the vector delta, the identity is wrong. The counterexample is a map and a number.

# %%
misprint = blossom.prove("map p degree 2\nclaim p'(t) == 2 * p[t, 1]")
assert not misprint and misprint.verdict == "refuted"
counterexample = misprint.counterexample
print(counterexample["maps"], counterexample["variables"], counterexample["left"], "is not", counterexample["right"])

# %% [markdown]
# The counterexample can be checked by hand.

# %%
wrong = blossom.Map(counterexample["maps"]["p"])
at = counterexample["variables"]["t"]
assert wrong.derivative(at=[at])[0] != 2 * wrong[at, 1]
