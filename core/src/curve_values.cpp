#include <blossom/core/conversion.hpp>
#include <blossom/core/curve_values.hpp>
#include <blossom/core/taylor_curve.hpp>
#include <blossom/rational/form_values.hpp>

#include <atomic>
#include <bit>
#include <limits>
#include <mutex>
#include <optional>

#include "on_threads.hpp"
#include "progressive_frame.hpp"

namespace blossom {

/// Forms, and whether their values at all parameters in words are within the limits.
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
        const auto numerator = t.numerator().to_int64();
        const auto denominator = t.denominator().to_int64();
        if (numerator && denominator) return evaluate(*numerator, *denominator, values);
        const std::size_t bits = std::max(t.numerator().bit_length(), t.denominator().bit_length());
        require_result_bits(forms_.value_bits(bits), limits_, values.size());
        forms_.evaluate(t, values);
    }
    /// At numerator / denominator in lowest terms.
    void evaluate(std::int64_t numerator, std::int64_t denominator, std::span<Rational> values) const {
        if (words_are_within_ && numerator != std::numeric_limits<std::int64_t>::min())
            return forms_.evaluate(numerator, denominator, values);
        const auto bits = static_cast<std::size_t>(
            std::bit_width(static_cast<std::uint64_t>(numerator < 0 ? ~numerator : numerator) |
                           static_cast<std::uint64_t>(denominator)));
        require_result_bits(forms_.value_bits(bits + 1), limits_, values.size());
        forms_.evaluate(Rational(numerator, denominator), values);
    }

private:
    FormValues forms_;
    Limits limits_;
    bool words_are_within_;
};

namespace {

/// `evaluate(t, values)` for every parameter.
template <class Evaluate>
std::vector<Rational> values_at(std::span<const Rational> parameters, std::size_t dimension, std::size_t jobs,
                                const Evaluate& evaluate) {
    std::vector<Rational> values(parameters.size() * dimension);
    on_threads(parameters.size(), jobs, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            evaluate(parameters[i], std::span(values).subspan(i * dimension, dimension));
    });
    return values;
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
    Coordinates value(dimension());
    forms_->evaluate(t.value, value);
    return value;
}

std::vector<Rational> CurveValues::at(std::span<const Rational> parameters, std::size_t jobs) const {
    return values_at(parameters, dimension(), jobs,
                     [&](const Rational& t, std::span<Rational> value) { forms_->evaluate(t, value); });
}

__extension__ using SignedWide = __int128;

/// What all copies share: the curve and its segments, each prepared once.
class SplineValues::Segments {
public:
    Segments(const BSplineCurve& curve, const Limits& limits)
        : curve_(curve),
          limits_(limits),
          segments_(std::make_unique<Segment[]>(curve.knots().size())),
          knots_(curve.knots().knots()) {
        for (const Integer& knot : knots_.numerators()) {
            const auto word = knot.to_int64();
            if (!word) return;
            words_.push_back(*word);
            greatest_ = std::max(greatest_, *word < 0 ? ~*word : *word);
        }
        if (const auto word = knots_.denominator().to_int64()) denominator_ = *word;
    }

    std::size_t dimension() const { return curve_.dimension(); }

    void evaluate(const Rational& t, std::span<Rational> values) const {
        const auto numerator = t.numerator().to_int64();
        const auto denominator = t.denominator().to_int64();
        if (denominator_ == 0 || !numerator || !denominator) {
            const Segment& segment = prepared(curve_.knots().span_at(t));
            return segment.forms->evaluate(t - segment.origin, values);
        }
        const Segment& segment = prepared(span_of(t, *numerator, *denominator));
        // t less an integer is in lowest terms too.
        std::int64_t moved = 0;
        if (__builtin_mul_overflow(segment.word_origin, *denominator, &moved) ||
            __builtin_sub_overflow(*numerator, moved, &moved))
            return segment.forms->evaluate(t - segment.origin, values);
        segment.forms->evaluate(moved, *denominator, values);
    }

private:
    struct Segment {
        std::atomic<bool> is_ready = false;
        std::once_flag once;
        Integer origin;
        std::int64_t word_origin = 0;  ///< the same where knots are words
        std::optional<CurveValues::Forms> forms;
    };

    const Segment& prepared(std::size_t span) const {
        Segment& segment = segments_[span];
        if (!segment.is_ready.load(std::memory_order_acquire))
            std::call_once(segment.once, [&] { prepare(span, segment); });
        return segment;
    }

    void prepare(std::size_t span, Segment& segment) const {
        const KnotVector& knots = curve_.knots();
        const ProgressiveFrame frame(knots.around(span), curve_.points_of(span), limits_);
        const PolynomialCurve whole =
            monomial_form(frame.control_points(Interval(knots[span], knots[span + 1])), limits_);
        segment.origin = floor_of(knots[span]);
        segment.word_origin = segment.origin.to_int64().value_or(0);
        segment.forms.emplace(taylor_form(whole, segment.origin, limits_).coefficients, limits_);
        segment.is_ready.store(true, std::memory_order_release);
    }

    /// As KnotVector::span_at, by products of words, for t = numerator / denominator.
    std::size_t span_of(const Rational& t, std::int64_t numerator, std::int64_t denominator) const {
        const SignedWide place = SignedWide{numerator} * denominator_;
        // 128 bits in words of 64 where they suffice.
        constexpr std::int64_t most = std::int64_t{1} << 31;
        const bool small = greatest_ < most && denominator < most &&
                           place == static_cast<SignedWide>(static_cast<std::int64_t>(place));
        const std::size_t span = small ? span_of(static_cast<std::int64_t>(place), denominator)
                                       : span_of(place, SignedWide{denominator});
        return span == 0 ? curve_.knots().span_at(t) : span;
    }

    /// The last span whose beginning is not above place / denominator, and 0 outside of the domain and at its
    /// end. A bisection whose steps do not depend on what is found, so that none is mispredicted; of the last
    /// few knots those below are counted, which need not wait for each other.
    template <class Word>
    std::size_t span_of(Word place, Word denominator) const {
        const auto is_above = [&](std::size_t i) { return place < Word{words_[i]} * denominator; };
        std::size_t begin = curve_.knots().begin_index();
        std::size_t size = curve_.knots().end_index() - begin;
        if (is_above(begin) || !is_above(begin + size)) return 0;
        constexpr std::size_t most_counted = 12;
        while (size > most_counted) {
            const std::size_t half = size / 2;
            begin += is_above(begin + half) ? 0 : half;
            size -= half;
        }
        std::size_t below = 0;
        for (std::size_t i = 1; i < size; ++i) below += is_above(begin + i) ? 0U : 1U;
        return begin + below;
    }

    BSplineCurve curve_;
    Limits limits_;
    std::unique_ptr<Segment[]> segments_;
    RationalVector knots_;
    std::vector<std::int64_t> words_;  ///< the knots over `denominator_`
    std::int64_t greatest_ = 0;        ///< bounds their magnitudes, up to one
    std::int64_t denominator_ = 0;     ///< 0 unless all are words
};

SplineValues::SplineValues(const BSplineCurve& curve, const Limits& limits)
    : segments_(std::make_shared<const Segments>(curve, limits)) {}

std::size_t SplineValues::dimension() const { return segments_->dimension(); }

Coordinates SplineValues::operator()(const Parameter& t) const {
    Coordinates value(dimension());
    segments_->evaluate(t.value, value);
    return value;
}

std::vector<Rational> SplineValues::at(std::span<const Rational> parameters, std::size_t jobs) const {
    return values_at(parameters, dimension(), jobs,
                     [&](const Rational& t, std::span<Rational> value) { segments_->evaluate(t, value); });
}

}  // namespace blossom
