#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/maps/taylor_curve.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/curve_values.hpp>
#include <blossom/rational/made_once.hpp>
#include <blossom/rational/prepared_polynomial.hpp>

#include <algorithm>
#include <limits>

#include "maps/on_threads.hpp"
#include "maps/result_room.hpp"

namespace blossom {

/// The prepared polynomials, and whether their values at all parameters in words are within the limits.
class CurveValues::Forms {
public:
    Forms(const PointArray& coefficients, const Limits& limits)
        : forms_(coefficients.numbers(), coefficients.dimension()), limits_(limits) {
        constexpr std::size_t word_bits = 64;
        const std::size_t digits = forms_.value_bits(word_bits) / 3 + 1;
        words_are_within_ = digits <= limits.digits && digits * dimension() <= limits.output_digits;
    }

    std::size_t dimension() const { return forms_.rows(); }

    void evaluate(const Rational& t, std::span<Rational> values) const {
        if (t.numerator().is_word() && t.denominator().is_word())
            return evaluate(t.numerator().word(), t.denominator().word(), values);
        evaluate_any(t, values);
    }
    /// The values at numerator / denominator in lowest terms.
    void evaluate(std::int64_t numerator, std::int64_t denominator, std::span<Rational> values) const {
        if (words_are_within_ && numerator != std::numeric_limits<std::int64_t>::min())
            return forms_.evaluate(numerator, denominator, values);
        evaluate_any(Rational(numerator, denominator), values);
    }

private:
    [[gnu::noinline]] void evaluate_any(const Rational& t, std::span<Rational> values) const {
        const std::size_t bits = std::max(t.numerator().bit_length(), t.denominator().bit_length());
        require_result_bits(forms_.value_bits(bits), limits_, values.size());
        forms_.evaluate(t, values);
    }

    PreparedPolynomial forms_;
    Limits limits_;
    bool words_are_within_;
};

namespace {

/// Calls evaluate(t, results) for every parameter.
template <class Evaluate>
void set_values(std::span<const Rational> parameters, std::size_t dimension, std::span<Rational> results,
                std::size_t jobs, const Evaluate& evaluate) {
    require_room(parameters.size(), "parameters", dimension, results.size());
    on_threads(parameters.size(), jobs, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            evaluate(parameters[i], results.subspan(i * dimension, dimension));
    });
}

Integer floor_of(const Rational& value) {
    Integer quotient = value.numerator() / value.denominator();
    if (value.sign() < 0 && !value.is_integer()) quotient -= 1;
    return quotient;
}

}  // namespace

CurveValues::CurveValues(const PolynomialCurve& curve, const Limits& limits)
    : forms_(std::make_shared<const Forms>(curve.coefficients(), limits)) {}

CurveValues::CurveValues(const BezierCurve& curve, const Limits& limits)
    : CurveValues(monomial_form(curve, limits), limits) {}

std::size_t CurveValues::dimension() const { return forms_->dimension(); }

Coordinates CurveValues::operator()(const Parameter& t) const {
    return written(dimension(), [&](std::span<Rational> value) { forms_->evaluate(t.value, value); });
}

std::vector<Rational> CurveValues::at(std::span<const Rational> parameters, std::size_t jobs) const {
    return written(parameters.size() * dimension(),
                   [&](std::span<Rational> results) { at(parameters, results, jobs); });
}

void CurveValues::at(std::span<const Rational> parameters, std::span<Rational> results,
                     std::size_t jobs) const {
    set_values(parameters, dimension(), results, jobs,
               [&](const Rational& t, std::span<Rational> result) { forms_->evaluate(t, result); });
}

/// The data that all copies share: the curve and its segments, each prepared once.
class SplineValues::Segments {
public:
    Segments(const BSplineCurve& curve, const Limits& limits)
        : curve_(curve),
          limits_(limits),
          segments_(std::make_unique<MadeOnce<Segment>[]>(curve.knots().size())),
          knots_(curve.knots().knots()) {
        read_words();
    }

    std::size_t dimension() const { return curve_.dimension(); }

    void evaluate(const Rational& t, std::span<Rational> values) const {
        if (denominator_ == 0 || !t.numerator().is_word() || !t.denominator().is_word())
            return evaluate_any(t, values);
        const std::int64_t numerator = t.numerator().word();
        const std::int64_t denominator = t.denominator().word();
        const Segment& segment = prepared(span_of(t, numerator, denominator));
        // t minus an integer is also in lowest terms.
        std::int64_t moved = 0;
        if (__builtin_mul_overflow(segment.word_origin, denominator, &moved) ||
            __builtin_sub_overflow(numerator, moved, &moved))
            return evaluate_any(t, values);
        segment.forms.evaluate(moved, denominator, values);
    }

private:
    struct Segment {
        Integer origin;
        std::int64_t word_origin;  ///< the same if knots are words
        CurveValues::Forms forms;
    };

    [[gnu::noinline]] void evaluate_any(const Rational& t, std::span<Rational> values) const {
        const Segment& segment = prepared(curve_.knots().span_at(t));
        segment.forms.evaluate(t - segment.origin, values);
    }

    const Segment& prepared(std::size_t span) const {
        return segments_[span].value([&] { return segment(span); });
    }

    Segment segment(std::size_t span) const {
        const KnotVector& knots = curve_.knots();
        const PolynomialCurve whole = monomial_form(sablonniere(curve_, span, limits_), limits_);
        const Integer origin = floor_of(knots[span]);
        return {origin, origin.to_int64().value_or(0),
                CurveValues::Forms(taylor_form(whole, origin, limits_).coefficients, limits_)};
    }

    void read_words() {
        for (const Integer& knot : knots_.numerators()) {
            if (!knot.is_word()) return;
            words_.push_back(knot.word());
        }
        denominator_ = knots_.denominator().word();
        list_spans();
    }

    /// Lists the spans of all integers from the first to the last knot of the domain, unless they are too
    /// many.
    void list_spans() {
        constexpr std::uint64_t most = 1024;
        const std::size_t begin = curve_.knots().begin_index();
        const std::size_t end = curve_.knots().end_index();
        first_ = words_[begin];
        last_ = words_[end];
        if (static_cast<std::uint64_t>(last_) - static_cast<std::uint64_t>(first_) > most) return;
        std::size_t span = begin;
        for (std::int64_t place = first_; place < last_; ++place) {
            while (words_[span + 1] <= place) ++span;
            spans_.push_back(static_cast<std::uint32_t>(span));
        }
    }

    /// The span of KnotVector::span_at for t = numerator / denominator: no knot lies between t and its floor
    /// after both are multiplied by the denominator of the knots.
    std::size_t span_of(const Rational& t, std::int64_t numerator, std::int64_t denominator) const {
        std::int64_t place = 0;
        if (__builtin_mul_overflow(numerator, denominator_, &place)) return curve_.knots().span_at(t);
        const std::int64_t quotient = place / denominator;
        const std::int64_t floor = quotient - (quotient * denominator > place ? 1 : 0);
        if (floor < first_ || floor >= last_) return curve_.knots().span_at(t);
        if (!spans_.empty()) return spans_[static_cast<std::size_t>(floor - first_)];
        const auto* const first = words_.data() + curve_.knots().begin_index();
        const auto* const last = words_.data() + curve_.knots().end_index();
        return static_cast<std::size_t>(std::upper_bound(first, last, floor) - words_.data()) - 1;
    }

    BSplineCurve curve_;
    Limits limits_;
    std::unique_ptr<MadeOnce<Segment>[]> segments_;
    RationalVector knots_;
    std::vector<std::int64_t> words_;  ///< the knots over `denominator_`
    std::int64_t denominator_ = 0;     ///< 0 unless all knots are words
    std::int64_t first_ = 0;           ///< the ends of the domain over `denominator_`
    std::int64_t last_ = 0;
    std::vector<std::uint32_t> spans_;  ///< of first_, first_ + 1, ..., last_ - 1; may be empty
};

SplineValues::SplineValues(const BSplineCurve& curve, const Limits& limits)
    : segments_(std::make_shared<const Segments>(curve, limits)) {}

std::size_t SplineValues::dimension() const { return segments_->dimension(); }

Coordinates SplineValues::operator()(const Parameter& t) const {
    return written(dimension(), [&](std::span<Rational> value) { segments_->evaluate(t.value, value); });
}

std::vector<Rational> SplineValues::at(std::span<const Rational> parameters, std::size_t jobs) const {
    return written(parameters.size() * dimension(),
                   [&](std::span<Rational> results) { at(parameters, results, jobs); });
}

void SplineValues::at(std::span<const Rational> parameters, std::span<Rational> results,
                      std::size_t jobs) const {
    set_values(parameters, dimension(), results, jobs,
               [&](const Rational& t, std::span<Rational> result) { segments_->evaluate(t, result); });
}

}  // namespace blossom
