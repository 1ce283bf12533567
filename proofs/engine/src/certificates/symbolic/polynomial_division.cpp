#include "polynomial_merging.hpp"

#include <algorithm>

namespace blossom::proofs::second {

namespace {

/// Divides integer polynomials of one layout: merges, in descending order, the terms of the dividend and the
/// products of the quotient with each term of the divisor but the first.
class ExactDivision {
public:
    ExactDivision(const PlainPolynomial& dividend, const PlainPolynomial& divisor, Budget& budget)
        : dividend_(dividend),
          divisor_(divisor),
          budget_(budget),
          width_(dividend.width()),
          guards_(PolynomialParts::guards(dividend)),
          heads_(divisor.size() * width_),
          places_(divisor.size()),
          quotient_(PolynomialParts::empty(PolynomialParts::bits(dividend), width_,
                                           PolynomialParts::largest(dividend))) {
        for (std::size_t stream = 1; stream < divisor.size(); ++stream) waiting_.push_back(stream);
    }

    std::optional<PlainPolynomial> result() {
        std::vector<std::uint64_t> monomial(width_);
        while (next_ < dividend_.size() || !active_.empty()) {
            Integer coefficient = take_greatest(monomial.data());
            if (coefficient.is_zero()) continue;
            if (!divide_monomial(monomial.data())) return std::nullopt;
            const Integer& leading = PolynomialParts::coefficients(divisor_).front();
            if (!leading.is_one()) {
                Integer exact = coefficient / leading;
                if (exact * leading != coefficient) return std::nullopt;
                coefficient = std::move(exact);
            }
            PolynomialParts::append(quotient_, monomial.data(), std::move(coefficient));
            budget_.require_terms(quotient_.size(), width_);
            for (const std::size_t stream : waiting_) activate(stream);
            waiting_.clear();
        }
        return std::move(quotient_);
    }

private:
    std::uint64_t* head(std::size_t stream) { return heads_.data() + stream * width_; }
    auto before() {
        return
            [this](std::size_t a, std::size_t b) { return compared_monomials(head(a), head(b), width_) < 0; };
    }

    /// The sum of the coefficients of the greatest remaining monomial.
    Integer take_greatest(std::uint64_t* monomial) {
        Integer result = 0;
        const bool from_dividend =
            next_ < dividend_.size() &&
            (active_.empty() ||
             compared_monomials(dividend_.monomial(next_), head(active_.front()), width_) >= 0);
        std::copy_n(from_dividend ? dividend_.monomial(next_) : head(active_.front()), width_, monomial);
        if (from_dividend) result = PolynomialParts::coefficients(dividend_)[next_++];
        while (!active_.empty() && compared_monomials(head(active_.front()), monomial, width_) == 0) {
            std::ranges::pop_heap(active_, before());
            const std::size_t stream = active_.back();
            active_.pop_back();
            result -= PolynomialParts::coefficients(quotient_)[places_[stream]++] *
                      PolynomialParts::coefficients(divisor_)[stream];
            if (places_[stream] < quotient_.size()) {
                activate(stream);
            } else {
                waiting_.push_back(stream);
            }
        }
        budget_.spend(1);
        return result;
    }

    void activate(std::size_t stream) {
        budget_.spend(1);
        const std::uint64_t* of_quotient = quotient_.monomial(places_[stream]);
        const std::uint64_t* of_divisor = divisor_.monomial(stream);
        for (std::size_t k = 0; k < width_; ++k) head(stream)[k] = of_quotient[k] + of_divisor[k];
        active_.push_back(stream);
        std::ranges::push_heap(active_, before());
    }

    /// Divides by the first monomial of the divisor if possible.
    bool divide_monomial(std::uint64_t* monomial) const {
        const std::uint64_t* leading = divisor_.monomial(0);
        for (std::size_t k = 0; k < width_; ++k) {
            if ((((monomial[k] | guards_) - leading[k]) & guards_) != guards_) return false;
            monomial[k] -= leading[k];
        }
        return true;
    }

    const PlainPolynomial& dividend_;
    const PlainPolynomial& divisor_;
    Budget& budget_;
    std::size_t width_;
    std::uint64_t guards_;
    std::size_t next_ = 0;              ///< the next term of the dividend
    std::vector<std::uint64_t> heads_;  ///< the greatest remaining monomial of each stream
    std::vector<std::size_t> places_;   ///< the term of the quotient from which it comes, per stream
    std::vector<std::size_t> active_;   ///< a heap of streams
    std::vector<std::size_t> waiting_;  ///< streams for which the quotient has no term yet
    PlainPolynomial quotient_;
};

/// Whether one monomial divides another in the layout of a polynomial.
bool divides_monomial(const std::uint64_t* divisor, const std::uint64_t* monomial, std::size_t width,
                      std::uint64_t guards) {
    for (std::size_t k = 0; k < width; ++k) {
        if ((((monomial[k] | guards) - divisor[k]) & guards) != guards) return false;
    }
    return true;
}

}  // namespace

std::optional<PlainPolynomial> exact_quotient(const PlainPolynomial& a, const PlainPolynomial& divisor,
                                              Budget& budget) {
    if (divisor.is_zero()) return std::nullopt;
    if (a.is_zero()) return a;
    if (divisor.is_number()) return scaled(a, Rational(1) / divisor.number(), budget);
    // The first and the last term of a product are the products of those of its factors.
    const std::size_t shared = std::min(a.width(), divisor.width());
    if (PolynomialParts::bits(a) == PolynomialParts::bits(divisor)) {
        const std::uint64_t guards = PolynomialParts::guards(a);
        if (!divides_monomial(divisor.monomial(0), a.monomial(0), shared, guards) ||
            !divides_monomial(divisor.monomial(divisor.size() - 1), a.monomial(a.size() - 1), shared,
                              guards)) {
            return std::nullopt;
        }
    }
    const AlignedPolynomials both(a, divisor, false, budget);
    std::optional<PlainPolynomial> result = ExactDivision(both.first(), both.second(), budget).result();
    if (!result) return std::nullopt;
    PolynomialParts::denominator(*result) = PolynomialParts::denominator(a);
    PolynomialParts::reduce(*result);
    return result;
}

}  // namespace blossom::proofs::second
