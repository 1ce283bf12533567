\\ The blossom of degree n from values at the means of its arguments, expanded. With the coefficients as main variables and all
\\ powers of a mean at once PARI takes the least time of what was tried.
default(parisizemax, "4G");
z;
c = vector(n + 1, i, eval(Str("'c", i - 1)));
t = vector(n, i, eval(Str("'t", i)));
value(u) = { my(p = powers(u, n)); sum(k = 0, n, c[k+1]*p[k+1]) };
blossom(v) = { my(e = Vecrev(vecprod([1 + u*'z | u <- v]), n + 1)); sum(k = 0, n, c[k+1]/binomial(n, k)*e[k+1]) };
r = 0;
for (N = 1, n, s = 0; forsubset([n, N], S, s += value(sum(i = 1, N, t[S[i]])/N)); r += (-1)^(n - N)*N^n*s);
print(r/n! == blossom(t));
