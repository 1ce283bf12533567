#include <blossom/proofs/formatter.hpp>
#include <blossom/proofs/parser.hpp>
#include <blossom/worked/general_statement.hpp>
#include <blossom/worked/notation.hpp>

#include <string>

#include "support/catch.hpp"

using namespace blossom;
using namespace blossom::worked;

namespace {

constexpr Notation brackets{BlossomStyle::brackets, false};

proofs::Block block_of(const std::string& text) {
    proofs::Document document = proofs::parse(text);
    REQUIRE(document.errors.empty());
    return document.blocks.at(0);
}

/// The left side of a claim after these lines, in LaTeX.
std::string latex(const std::string& expression, const std::string& lines = "") {
    const proofs::Block block = block_of(lines + "claim " + expression + " == 0");
    return to_latex(formula_of(block, block.statements.back().sides[0]), brackets);
}

std::string in_words(const Text& text) {
    std::string words;
    for (const Text::Part& part : text.parts()) {
        const auto* formula = std::get_if<Formula>(&part);
        words += formula ? to_text(*formula, brackets) : std::get<std::string>(part);
    }
    return words;
}

std::string declared(const std::string& lines) { return in_words(declarations_in_words(block_of(lines))); }

/// The verdict on the last line of a block.
std::string verdict(const std::string& lines) {
    const proofs::Block block = block_of(lines);
    return in_words(verdict_in_words(block, proofs::decide(block).back()));
}

}  // namespace

TEST_CASE("arithmetic has the parentheses that it needs") {
    CHECK(latex("1.5*x - (y - z)") == R"(\tfrac{3}{2}\,x - (y - z))");
    CHECK(latex("-2*x*(-3) + -y") == R"(-2\,x\,(-3) - y)");
    CHECK(latex("-(x + y)*z") == R"(-(x + y)\,z)");
    CHECK(latex("x/y/(z + 1)") == R"(\frac{\frac{x}{y}}{z + 1})");
    CHECK(latex("((x - a)/(b - a))^2") == R"({\left(\frac{x - a}{b - a}\right)}^{2})");
    CHECK(latex("(-1)^(n - k)*x^2^3") == R"({(-1)}^{n - k}\,{x}^{{2}^{3}})");
    CHECK(latex("x - y - z") == "x - y - z");
    CHECK(latex("x - (y + z)") == "x - (y + z)");
    CHECK(latex("x/2 + 1/2") == R"(\frac{x}{2} + \tfrac{1}{2})");
    CHECK(latex("factorial(n - 1)*binomial(n, k)") == R"((n - 1)!\,\binom{n}{k})");
}

TEST_CASE("names are those of mathematics") {
    CHECK(latex("t_1 + c_{i,j+1}") == "{t}_{1} + {c}_{i, j + 1}");
    CHECK(latex("alpha*beta_2 + Gamma") == R"(\alpha\,{\beta}_{2} + \Gamma)");
    CHECK(latex("area*x") == R"(\mathit{area}\,x)");
    CHECK(latex("t_1^2") == "{t}_{1}^{2}");
}

TEST_CASE("blossom values and their arguments") {
    CHECK(latex("b[t_1..t_n]") == R"(b[{t}_{1}, \dots, {t}_{n}])");
    CHECK(latex("b[t_1..t_3, t_2..t_2, s_1..s_4]") ==
          R"(b[{t}_{1}, {t}_{2}, {t}_{3}, {t}_{2}, {s}_{1}, \dots, {s}_{4}])");
    CHECK(latex("b[t{n-k}, delta{k}]") == R"(b[{t}^{\langle n - k\rangle}, {\delta}^{\langle k\rangle}])");
    CHECK(latex("b[(s + t){n}, t{2}, t{0}]") == R"(b[{(s + t)}^{\langle n\rangle}, t, t])");
    CHECK(latex("b[t_i : i in 1..n, i != k, i not in S]") ==
          R"(b[{({t}_{i})}_{1 \le i \le n, i \ne k, i \notin S}])");
    CHECK(latex("b[<u_i, m_i> : i in S]") == R"(b[{(\langle {u}_{i}, {m}_{i}\rangle)}_{i \in S}])");
    CHECK(latex("f[u{n}; v_1, v_2]") == R"(f[{u}^{\langle n\rangle}; {v}_{1}, {v}_{2}])");
    CHECK(latex("b(t + h*delta)") == R"(b(t + h\,\delta))");
    CHECK(latex("q[(x, y), (1, 2)]") == "q[(x, y), (1, 2)]");
}

TEST_CASE("derivatives") {
    CHECK(latex("b'(t) + b''(t)") == "b'(t) + b''(t)");
    CHECK(latex("D(b, 4)(t)") == "{b}^{(4)}(t)");
    CHECK(latex("D(b, k + 1)(t)") == "{b}^{(k + 1)}(t)");
    CHECK(latex("D(f, 1, j)(u, v)") == R"({\partial}_{1}\,{\partial}_{2}^{j}\,f(u, v))");
    CHECK(latex("D(f, 0, 2)(u, v)") == R"({\partial}_{2}^{2}\,f(u, v))");
    CHECK(latex("D(q, d, e)(r)", "map q degree 2 on simplex 2\n") == R"({D}_{d}\,{D}_{e}\,q(r))");
    CHECK(latex("D(p, d)(r)", "map q degree 2 on simplex 2\nraise q to 3 as p\n") == R"({D}_{d}\,p(r))");
    CHECK(latex("D(t^3 + x, t)") == R"(\frac{\partial}{\partial\,t}\,({t}^{3} + x))");
    CHECK(latex("D(b(t), t_1, k)") == R"(\frac{{\partial}^{k}}{\partial\,{t}_{1}^{k}}\,b(t))");
}

TEST_CASE("sums, products and means over ranges and sets") {
    CHECK(latex("sum(i, 0, n, a_i)*2 + sum(i, 1, n, a_i + 1)") ==
          R"(\left(\sum_{i = 0}^{n} {a}_{i}\right) \cdot 2 + \sum_{i = 1}^{n} ({a}_{i} + 1))");
    CHECK(latex("2*sum(i, 1, n, sum(j, i, n, a_i*a_j))") ==
          R"(2\,\sum_{i = 1}^{n} \sum_{j = i}^{n} {a}_{i}\,{a}_{j})");
    CHECK(latex("sum(S, subsets(n, k), prod(i, S, t_i))") ==
          R"(\sum_{S \subseteq \{1, \dots, n\}, |S| = k} \prod_{i \in S} {t}_{i})");
    CHECK(latex("sum(S, subsets(n, k), sum(T, subsets(S, 1), size(T)))") ==
          R"(\sum_{S \subseteq \{1, \dots, n\}, |S| = k} \sum_{T \subseteq S, |T| = 1} |T|)");
    CHECK(latex("prod(i, without(n, S), t_i)") == R"(\prod_{i \in \{1, \dots, n\} \setminus S} {t}_{i})");
    CHECK(latex("mean(i, 1, n, t_i)") == R"(\frac{1}{n}\,\sum_{i = 1}^{n} {t}_{i})");
    CHECK(latex("mean(i, 0, n - 1, t_i)") == R"(\frac{1}{n}\,\sum_{i = 0}^{n - 1} {t}_{i})");
    CHECK(latex("mean(i, k, n, t_i)") == R"(\frac{1}{n - k + 1}\,\sum_{i = k}^{n} {t}_{i})");
    CHECK(latex("mean(S, subsets(3, 2), size(S))") ==
          R"(\frac{1}{\tbinom{3}{2}}\,\sum_{S \subseteq \{1, 2, 3\}, |S| = 2} |S|)");
    CHECK(latex("sum(P, partitions(n), prod(B, P, size(B)))") ==
          R"(\sum_{P \in \text{Part}(\{1, \dots, n\})} \prod_{B \in P} |B|)");
    CHECK(latex("sum(P, permutations(n), sign(P)*prod(i, 1, n, x_{i,P(i)}))") ==
          R"(\sum_{P \in \text{Perm}(\{1, \dots, n\})} \text{sgn}(P)\,\prod_{i = 1}^{n} {x}_{i, P(i)})");
}

TEST_CASE("functions with notations of their own") {
    CHECK(latex("bernstein(i, n, t)") == "{B}_{i}^{n}(t)");
    CHECK(latex("bspline(j, d, x, i, t)") == "{N}_{j, d}^{[{x}_{i}, {x}_{i + 1}]}(t)");
    CHECK(latex("determinant(i, j, n, x_{i,j})") == R"({\det({x}_{i, j})}_{i, j = 1}^{n})");
    CHECK(latex("if(i <= j, a, 0)") ==
          R"(\begin{cases} a & \text{if } i \le j \\ 0 & \text{otherwise} \end{cases})");
    CHECK(
        latex("if(i not in S, a, 0)*2") ==
        R"(\left(\begin{cases} a & \text{if } i \notin S \\ 0 & \text{otherwise} \end{cases}\right) \cdot 2)");
}

TEST_CASE("what the prover writes is read as formulas") {
    const auto text = [](std::string_view written) { return to_latex(formula_of_text(written), brackets); };
    CHECK(text("a != b") == R"(a \ne b)");
    CHECK(text("3t^2 - 1/2 x_1 == 0") == R"(3\,{t}^{2} - \tfrac{1}{2}\,{x}_{1} = 0)");
    CHECK(text("b[0, delta] = 2") == R"(b[0, \delta] = 2)");
    CHECK(text("(2w)/(3)") == R"(\frac{2\,w}{3})");
    CHECK(text("b.0 + b.1 != 0") == R"(\text{b.0 + b.1} \ne 0)");
}

TEST_CASE("declarations are sentences") {
    CHECK(declared("map b, c degree n") == "Let b and c be polynomials of formal degree n.");
    CHECK(declared("map f degrees m, 2") == "Let f be a polynomial of formal degrees m, 2 in 2 variables.");
    CHECK(declared("map q degree 2 on simplex 2 net c over r, s, t\nframe r, s, t in 2") ==
          "Let q be a polynomial of formal degree 2 on an affine space of dimension 2. Its control points "
          "over r, s "
          "and t are q[r^<i₀>, s^<i₁>, t^<i₂>] = c_(i₀, i₁, i₂), for i₀ + i₁ + i₂ = 2. Let r, s and t be "
          "points in "
          "general position, which span an affine space of dimension 2.");
    CHECK(declared("map p degree n net c over a, b") ==
          "Let p be a polynomial of formal degree n. Its control points over a and b are p[a^<n − i>, b^<i>] "
          "= cᵢ, for "
          "i = 0, …, n.");
    CHECK(declared("point r in 2\nvector d, e in 2\nnumber s, t_1..t_n") ==
          "Let r be a point of an affine space of dimension 2. Let d and e be vectors of an affine space of "
          "dimension "
          "2. Let s, t₁, …, t_n be numbers.");
    CHECK(declared("poly P(x, y) degree 2 = x*y\nraise P to 3 as q") ==
          "Let P(x, y) = x y, of formal degree 2. Let q be P as a polynomial of formal degree 3.");
    CHECK(declared("let w_{0,i} = a_i\nlet w_{r,i} = w_{r-1,i}\nassume a != b\ngiven x == y for all x, y\n"
                   "given a_i == 0 for i in 0..n for all z_1..z_n") ==
          "Let w_(0, i) = aᵢ, w_(r, i) = w_(r − 1, i). Suppose that a ≠ b. Suppose that x = y for all x and "
          "y, and that "
          "aᵢ = 0 for i = 0, …, n and all z₁, …, z_n.");
    CHECK(declared("for n in 1..2\nclaim x == x").empty());
}

TEST_CASE("a claim in words") {
    const proofs::Block block =
        block_of("for n in 1..8\nrefute some a == b for i in 0..1 for j in 2..2\nclaim a == b");
    const ClaimInWords refuted = claim_in_words(block, block.statements[1], "Then");
    CHECK(refuted.before == "Then it is not true in every case that");
    CHECK(to_text(refuted.claim) == "a = b");
    CHECK(in_words(refuted.after) == "for n = 1, …, 8, i = 0, 1 and j = 2.");
    CHECK(claim_in_words(block, block.statements[2], "").before.empty());
}

TEST_CASE("verdicts say for which cases, and under which conditions") {
    CHECK(verdict("claim x == x") == "Proved.");
    CHECK(verdict("for n in 1..4\nclaim n*x/y == n*x/y") == "Proved for n = 1, …, 4, if y ≠ 0.");
    CHECK(verdict("assume y != 0\nclaim x/y == x/y") == "Proved.");
    CHECK(verdict("for n in 0..4\nclaim x^n == x") == "Refuted for n = 0, 2, 3, 4; it holds for n = 1.");
    CHECK(verdict("for n in 0..1\nfor k in 0..n\nclaim (n - k)*x == 0") ==
          "Refuted for (n, k) = (1, 0); it holds for (n, k) = (0, 0) and (1, 1).");
    CHECK(verdict("for n in 0..1\nfor k in 0..n\nclaim n*k == k*n") ==
          "Proved for n = 0, 1 and k = 0, …, n.");
    CHECK(verdict("for n in 0..1\nclaim sum(i, 1, n, 1/x_i) == sum(i, 1, n, 1/x_i)") ==
          "Proved for n = 0, 1, if x₁ ≠ 0 for n = 1.");
    CHECK(verdict("claim 1/0 == x") == "Undecided: the denominator is zero.");
}

TEST_CASE("a theorem is a fragment for LaTeX") {
    const proofs::Block block = block_of(
        "theorem misprint \"delta & 1\"\nfor n in 1..3\nmap a degree n\nrefute a'(t) == n*a[t{n-1}, 1]\n"
        "claim a'(t) == n*a[t{n-1}, delta]");
    CHECK(render_latex_theorem(block, proofs::decide(block)) == R"({\emergencystretch=3em\noindent
\textbf{delta \& 1.}
Let $a$ be a polynomial of formal degree $n$.
Then it is not true that
\[
  a'(t) = n\,a[{t}^{\langle n - 1\rangle}, 1]
\]
for $n = 1, 2, 3$.
\emph{Refuted for $n = 1, 2, 3$.}
For $n = 1$, $a(t) = 1$ of degree 1 and $t = 0$ the left side is $0$ and the right side $1$.
Moreover,
\[
  a'(t) = n\,a[{t}^{\langle n - 1\rangle}, \delta]
\]
for $n = 1, 2, 3$.
\emph{Proved for $n = 1, 2, 3$.}
\par}
)");
}

TEST_CASE("long formulas of a theorem are broken at their signs") {
    const proofs::Block block = block_of(
        "map a degree 2\nlet w = a[b*t_1 + c*s, t_2] + a[b*t_2 + c*s, t_1] + a[b*t_1, t_2]\n"
        "claim b*a[t_1, t_2] + c*a[s, t_2] - a[b*t_1 + c*s, t_2] + w - w == (b + c - 1)*a[0, t_2]");
    CHECK(render_latex_theorem(block, proofs::decide(block)) == R"({\emergencystretch=3em\noindent
Let $a$ be a polynomial of formal degree $2$. Let
\[
  w = a[b\,{t}_{1} + c\,s, {t}_{2}] + a[b\,{t}_{2} + c\,s, {t}_{1}] + a[b\,{t}_{1}, {t}_{2}].
\]
Then
\begin{align*}
  &b\,a[{t}_{1}, {t}_{2}] + c\,a[s, {t}_{2}] - a[b\,{t}_{1} + c\,s, {t}_{2}] + w - w \\
  &\quad {} = (b + c - 1)\,a[0, {t}_{2}].
\end{align*}
\emph{Proved.}
\par}
)");
}
