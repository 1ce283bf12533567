"""Counts and families of sets of integers."""


def binomial(n, k):
    if k < 0 or k > n:
        return 0
    out = 1
    for i in range(min(k, n - k)):
        out = out * (n - i) // (i + 1)
    return out


def factorial(n):
    out = 1
    for i in range(2, n + 1):
        out *= i
    return out


def multinomial(n, parts):
    out = factorial(n)
    for k in parts:
        out //= factorial(k)
    return out


def subsets_of(items, k):
    items = list(items)
    n = len(items)
    if k < 0 or k > n:
        return []
    out = []

    def grow(start, chosen):
        if len(chosen) == k:
            out.append(tuple(chosen))
            return
        for i in range(start, n - (k - len(chosen)) + 1):
            chosen.append(items[i])
            grow(i + 1, chosen)
            chosen.pop()

    grow(0, [])
    return out


def partitions_of(items):
    items = sorted(items)
    if not items:
        return [()]
    out = []
    first, rest = items[0], items[1:]
    for k in range(len(rest) + 1):
        for others in subsets_of(rest, k):
            left = [x for x in rest if x not in others]
            for more in partitions_of(left):
                out.append(((first,) + others,) + more)
    return out


def permutations_of(n):
    out = [()]
    for _ in range(n):
        out = [p + (x,) for p in out for x in range(1, n + 1) if x not in p]
    return out


def sign_of(p):
    s = 1
    for i in range(len(p)):
        for j in range(i):
            if p[j] > p[i]:
                s = -s
    return s


EXPONENTS = {}


def exponents(s, n):
    """All exponents of s variables with sum at most n."""
    key = (s, n)
    if key not in EXPONENTS:
        out = [()]
        for _ in range(s):
            out = [e + (k,) for e in out for k in range(n - sum(e) + 1)]
        EXPONENTS[key] = out
    return EXPONENTS[key]
