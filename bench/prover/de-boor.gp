\\ de Boor's algorithm of degree n with symbolic knots and one argument per level, as rational functions that PARI keeps in lowest
\\ terms, against the blossom by elementary symmetric functions. z comes first, so that it is the main variable.
default(parisizemax, "4G");
z;
x = vector(2*n, i, eval(Str("'x", i)));
u = vector(n, i, eval(Str("'u", i)));
c = vector(n + 1, i, eval(Str("'c", i - 1)));
blossom(v) = { my(e = Vecrev(vecprod([1 + t*'z | t <- v]), n + 1)); sum(k = 0, n, c[k+1]/binomial(n, k)*e[k+1]) };
w = vector(n + 1, i, blossom(Vec(x[i..i+n-1])));
for (r = 1, n, w = vector(n + 1 - r, i, ((x[i+n] - u[r])*w[i] + (u[r] - x[i+r-1])*w[i+1])/(x[i+n] - x[i+r-1])));
print(w[1] == blossom(u));
