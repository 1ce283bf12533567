// A web article on de Casteljau's algorithm and blossoms: its programs, run as they are printed and as they
// should be, on symbols.

#include <functional>
#include <stdexcept>

#include "support/map_printing.hpp"
#include "support/symbolic_curves.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// One level of a printed loop: `count` entries from neighbours, with a read past the end reported as Python
/// would.
Symbols level(const Symbols& below, std::size_t count, const Symbol& t) {
    Symbols entries;
    for (std::size_t i = 0; i < count; ++i) entries.push_back((1 - t) * below.at(i) + t * below.at(i + 1));
    return entries;
}

/// The recursive pseudo-code, where the loop of level r runs over `range(r)` entries with the parameter
/// `t(r)`.
Symbols run(std::size_t r, const Symbols& a, const std::function<std::size_t(std::size_t)>& range,
            const std::function<Symbol(std::size_t)>& t) {
    if (r == 0) return a;
    return level(run(r - 1, a, range, t), range(r), t(r));
}

/// Rows of control points and the greatest index that was read.
struct Matrix {
    Symbols rows;
    std::size_t greatest_read = 0;

    const Symbol& read(std::size_t i) {
        greatest_read = std::max(greatest_read, i);
        return rows.at(i);
    }
};

/// The C++ de_casteljau(t, num_recursions).
void de_casteljau(Matrix& points, std::size_t degree, const Symbol& t, std::size_t num_recursions) {
    if (num_recursions == 0) return;
    de_casteljau(points, degree, t, num_recursions - 1);
    points.greatest_read = 0;
    for (std::size_t i = 0; i < degree + 1 - num_recursions; ++i) {
        points.rows[i] = (1 - t) * points.read(i) + t * points.read(i + 1);
    }
}

}  // namespace

TEST_CASE("blog-py-decasteljau: range(n) reads past the end for n >= 2; range(n-r+1) gives C(t), n = 0..6",
          "[statement]") {
    // The printed base case `return a[i]` names no i at all; with the whole array returned the loop is still
    // wrong.
    for (std::size_t n = 0; n <= 6; ++n) {
        Variables variables;
        const Symbols a = variables.next(n + 1);
        const Symbol t = variables.next();
        const auto always_t = [&](std::size_t) { return t; };
        const auto printed = [&] { return run(n, a, [&](std::size_t) { return n; }, always_t); };
        if (n >= 2) {
            CHECK_THROWS_AS(printed(), std::out_of_range);
        } else {
            CHECK(printed().front() == bezier_value(a, 0, 1, t));
        }
        const Symbols corrected = run(n, a, [&](std::size_t r) { return n - r + 1; }, always_t);
        CHECK(corrected == Symbols{bezier_value(a, 0, 1, t)});
    }
}

TEST_CASE(
    "blog-py-blossom: range(r) reads past the end for n >= 2; range(n-r+1) with t_r gives the blossom, n = "
    "0..5",
    "[statement]") {
    for (std::size_t n = 0; n <= 5; ++n) {
        Variables variables;
        const Symbols a = variables.next(n + 1);
        const Symbols t = variables.next(n);
        const auto own_t = [&](std::size_t r) { return t[r - 1]; };
        const auto range = [&](std::size_t r) { return n - r + 1; };
        if (n >= 2) {
            CHECK_THROWS_AS(run(n, a, [](std::size_t r) { return r; }, own_t), std::out_of_range);
            // One common t, as printed, is the curve and not the blossom.
            const Symbols common = run(n, a, range, [&](std::size_t) { return t[0]; });
            CHECK(common == Symbols{bezier_value(a, 0, 1, t[0])});
            CHECK(common != Symbols{by_casteljau(a, 0, 1, 1, points(t))});
        }
        CHECK(run(n, a, range, own_t) == Symbols{by_casteljau(a, 0, 1, 1, points(t))});
    }
}

TEST_CASE(
    "blog-cpp-decasteljau: rows 0..n-r are a_i^r, and row n+1-r is read; the declared layout has too few "
    "rows",
    "[statement]") {
    for (std::size_t n = 0; n <= 5; ++n) {
        Variables variables;
        const Symbols a = variables.next(n + 1);
        const Symbol t = variables.next();
        const auto pyramid = symbolic_pyramid(a, 0, 1, copies(n, t));
        for (std::size_t r = 0; r <= n; ++r) {
            Matrix points{a};
            de_casteljau(points, n, t, r);
            for (std::size_t i = 0; i + r <= n; ++i) CHECK(points.rows[i] == pyramid[r][i]);
            // So that rows() >= n + 2 - r is needed, one more than the printed assertion asks for.
            if (r > 0) CHECK(points.greatest_read == n + 1 - r);
        }
    }
    // Matrix<_dim, _degree + 1> of a planar cubic has two rows; row 3 is read.
    Matrix declared{Symbols(2, 1)};
    CHECK_THROWS_AS(de_casteljau(declared, 3, Symbol::variable(0), 1), std::out_of_range);
}

TEST_CASE(
    "blog-cpp-blossom: the descending loop leaves a_0^j[t1..tj] in row j, and the blossom in the last, n = "
    "0..5",
    "[statement]") {
    for (std::size_t n = 0; n <= 5; ++n) {
        Variables variables;
        const Symbols a = variables.next(n + 1);
        const Symbols t = variables.next(n);
        const auto pyramid = symbolic_pyramid(a, 0, 1, points(t));
        Symbols rows = a;
        for (std::size_t r = 1; r <= n; ++r) {
            for (std::size_t j = n; j >= r; --j) rows[j] = (1 - t[r - 1]) * rows[j - 1] + t[r - 1] * rows[j];
            for (std::size_t j = r; j <= n; ++j) CHECK(rows[j] == pyramid[r][j - r]);
        }
        CHECK(rows[n] == by_casteljau(a, 0, 1, 1, points(t)));
        for (std::size_t j = 0; j <= n; ++j) CHECK(rows[j] == pyramid[j].front());
    }
}
