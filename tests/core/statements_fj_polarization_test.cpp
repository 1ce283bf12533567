// Fernandez-Jambrina: Inverse Relations for Blossoms and Parametrisations of Rational Curves and Surfaces
// (2024), section 3.
//
// f is the generic symmetric n-linear form on R^2, the homogeneous blossom of n + 1 symbolic coefficients,
// and the vectors x_i = (u_i, v_i) are symbols: each case decides its statement for all of them, at the
// degrees that it names.

#include <blossom/rational/combinatorics.hpp>

#include <bit>

#include "support/map_printing.hpp"
#include "support/symbolic_curves.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// A form f with vectors S = {x_1, ..., x_n}.
struct Form {
    Variables variables;
    Symbols c;
    SymbolicArguments x;

    explicit Form(std::size_t n) : c(variables.next(n + 1)) {
        for (std::size_t i = 0; i < n; ++i) {
            const Symbol u = variables.next();
            x.emplace_back(u, variables.next());
        }
    }

    std::size_t degree() const { return x.size(); }
    Symbol f(const SymbolicArguments& arguments) const { return by_symmetric_functions(c, arguments); }
    Symbol q(const SymbolicArgument& argument) const { return form_value(c, argument.u, argument.mass); }

    /// The sum of q(x_i1 + ... + x_iN) over all i1 < ... < iN.
    Symbol q_sum(std::size_t count) const {
        Symbols values;
        for (std::size_t subset = 0; subset < std::size_t{1} << degree(); ++subset) {
            if (static_cast<std::size_t>(std::popcount(subset)) != count) continue;
            SymbolicArgument total{0, 0};
            for (std::size_t i = 0; i < degree(); ++i) {
                if ((subset >> i & 1) == 0) continue;
                total.u += x[i].u;
                total.mass += x[i].mass;
            }
            values.push_back(q(total));
        }
        return sum(values);
    }

    /// The sum of f over all n-tuples of elements of S of which just `count` are different.
    Symbol f_sum(std::size_t count) const {
        Symbols values;
        add_tuples({}, 0, 0, count, factorial(degree()), values);
        return sum(values);
    }

private:
    /// Takes m copies of x_i for every m, one multiset after the other; `orders` becomes n! / prod m_i!.
    void add_tuples(const SymbolicArguments& chosen, std::size_t i, std::size_t distinct, std::size_t count,
                    const Integer& orders, Symbols& values) const {
        if (i == degree()) {
            if (chosen.size() == degree() && distinct == count) values.push_back(scaled(orders, f(chosen)));
            return;
        }
        for (std::size_t m = 0; m + chosen.size() <= degree(); ++m) {
            add_tuples(joined({chosen, copies(m, x[i])}), i + 1, distinct + (m > 0 ? 1 : 0), count,
                       divide_exactly(orders, factorial(m)), values);
        }
    }
};

}  // namespace

TEST_CASE("fj-eq14-15: q(x) = f(x,..,x) and q(l x) = l^n q(x), n = 1..6", "[statement]") {
    for (std::size_t n = 1; n <= 6; ++n) {
        Form form(n);
        const Symbol l = form.variables.next();
        const SymbolicArgument& x = form.x.front();
        CHECK(form.f(copies(n, x)) == form.q(x));
        CHECK(form.q({l * x.u, l * x.mass}) == pow(l, n) * form.q(x));
    }
}

TEST_CASE("fj-qN-def: q_1, q_2 and q_n written out, n = 3", "[statement]") {
    const Form form(3);
    const auto plus = [](const SymbolicArgument& a, const SymbolicArgument& b) {
        return SymbolicArgument{a.u + b.u, a.mass + b.mass};
    };
    const auto& x = form.x;
    CHECK(form.q_sum(1) == form.q(x[0]) + form.q(x[1]) + form.q(x[2]));
    CHECK(form.q_sum(2) == form.q(plus(x[0], x[1])) + form.q(plus(x[0], x[2])) + form.q(plus(x[1], x[2])));
    CHECK(form.q_sum(3) == form.q(plus(x[0], plus(x[1], x[2]))));
}

TEST_CASE("fj-qn-split: q_n(S) = f_1(S) + ... + f_n(S), n = 1..5", "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) {
        const Form form(n);
        Symbol total;
        for (std::size_t count = 1; count <= n; ++count) total += form.f_sum(count);
        CHECK(form.q_sum(n) == total);
    }
}

TEST_CASE("fj-eq16: f_1(S) is the sum of f(x_i,..,x_i), f_n(S) = n! f(x_1,..,x_n), n = 2..5", "[statement]") {
    for (std::size_t n = 2; n <= 5; ++n) {
        const Form form(n);
        Symbol total;
        for (const SymbolicArgument& x : form.x) total += form.f(copies(n, x));
        CHECK(form.f_sum(1) == total);
        CHECK(form.f_sum(n) == scaled(factorial(n), form.f(form.x)));
    }
}

TEST_CASE("fj-eq17-a: q_1(S) = f_1(S), n = 1..5", "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) {
        const Form form(n);
        CHECK(form.q_sum(1) == form.f_sum(1));
    }
}

TEST_CASE("fj-eq17-b: q_(n-1)(S) = (n-1) f_1(S) + (n-2) f_2(S) + ... + f_(n-1)(S), n = 2..5", "[statement]") {
    for (std::size_t n = 2; n <= 5; ++n) {
        const Form form(n);
        Symbol total;
        for (std::size_t m = 1; m + 1 <= n; ++m) total += scaled(n - m, form.f_sum(m));
        CHECK(form.q_sum(n - 1) == total);
    }
}

TEST_CASE("fj-eq17-c: q_N(S) = sum_M C(n-M,N-M) f_M(S), n = 1..5, all N", "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) {
        const Form form(n);
        for (std::size_t count = 1; count <= n; ++count) {
            Symbol total;
            for (std::size_t m = 1; m <= count; ++m)
                total += scaled(binomial(n - m, count - m), form.f_sum(m));
            CHECK(form.q_sum(count) == total);
        }
    }
}

TEST_CASE(
    "fj-alternating: the alternating sum of q_N(S) is f_n(S), n = 1..5, and of binomials (1-1)^(n-M), n <= "
    "12",
    "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) {
        const Form form(n);
        Symbol total;
        for (std::size_t count = 1; count <= n; ++count) {
            total += (n - count) % 2 == 0 ? form.q_sum(count) : -form.q_sum(count);
        }
        CHECK(total == form.f_sum(n));
    }
    for (std::size_t n = 1; n <= 12; ++n) {
        for (std::size_t m = 1; m <= n; ++m) {
            Integer total;
            for (std::size_t count = m; count <= n; ++count) {
                const Integer term = binomial(n - m, count - m);
                total += (n - count) % 2 == 0 ? term : -term;
            }
            CHECK(total == (n == m ? 1 : 0));
        }
    }
}

TEST_CASE("fj-thm1: n! f(x_1,..,x_n) is the alternating sum of the q_N(S), n = 1..5", "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) {
        const Form form(n);
        Symbol total;
        for (std::size_t count = 1; count <= n; ++count) {
            total += (n - count) % 2 == 0 ? form.q_sum(count) : -form.q_sum(count);
        }
        CHECK(total * fraction(1, factorial(n)) == form.f(form.x));
        CHECK(by_polarization(form.c, form.x) == form.f(form.x));
    }
}

TEST_CASE("fj-thm2: for points the sums become N^n q(mean of N), which evaluates the curve alone, n = 1..5",
          "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) {
        Variables variables;
        const Symbols c = variables.next(n + 1);
        const Symbols x = variables.next(n);
        Symbols terms;
        for (std::size_t subset = 1; subset < std::size_t{1} << n; ++subset) {
            const auto count = static_cast<std::size_t>(std::popcount(subset));
            Symbol total;
            for (std::size_t i = 0; i < n; ++i) {
                if ((subset >> i & 1) != 0) total += x[i];
            }
            const Symbol term =
                scaled(pow(Integer(count), n), polynomial_value(c, total * fraction(1, count)));
            terms.push_back((n - count) % 2 == 0 ? term : -term);
        }
        CHECK(sum(terms) * fraction(1, factorial(n)) == by_symmetric_functions(c, points(x)));
    }
}

TEST_CASE("fj-diag-consistency: the weights (-1)^(n-N) N^n C(n,N) sum to n!, n = 1..20", "[statement]") {
    for (std::size_t n = 1; n <= 20; ++n) {
        Integer total;
        for (std::size_t count = 1; count <= n; ++count) {
            const Integer term = pow(Integer(count), n) * binomial(n, count);
            total += (n - count) % 2 == 0 ? term : -term;
        }
        CHECK(total == factorial(n));
    }
}
