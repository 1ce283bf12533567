#include <blossom/rational/prepared_polynomial.hpp>

#include <algorithm>
#include <bit>
#include <limits>

#include "form_rows.hpp"
#include "sums/prepared_rows.hpp"
#include "sums/word_sums.hpp"

namespace blossom {

namespace {

/// The parameter t = u/v in words.
struct WordParameter {
    WordParameter(std::int64_t top, std::uint64_t bottom)
        : u(top), v(bottom), bits(static_cast<std::size_t>(std::bit_width(magnitude(top) | bottom))) {}

    std::int64_t u;
    std::uint64_t v;
    std::size_t bits;
};

/// sum_k C_k u^k v^(n-k); all arithmetic wraps, so that only the sum itself has to fit. Sets `power` to v^n.
template <class Word>
Word form_in(std::span<const std::int64_t> coefficients, const WordParameter& t, Word& power) {
    const auto u = static_cast<Word>(t.u);
    auto sum = static_cast<Word>(coefficients.back());
    power = 1;
    for (std::size_t k = coefficients.size() - 1; k-- > 0;) {
        power *= t.v;
        sum = sum * u + static_cast<Word>(coefficients[k]) * power;
    }
    return sum;
}

using Forms = PreparedPolynomial::Forms;

bool set_in_word(const Forms& form, const FormRow& row, const WordParameter& t, Rational& value) {
    const std::size_t n = form.degree;
    if (row.words.empty() || form.word_denominator == 0 || form.sum_bits + n * t.bits > 63) return false;
    std::uint64_t denominator = 0;
    const std::uint64_t sum = form_in(row.words, t, denominator);
    if (__builtin_mul_overflow(denominator, form.word_denominator, &denominator) || denominator >> 63 != 0)
        return false;
    const small_primes::Set primes =
        form.denominator_primes | (row.greatest.primes & small_primes::primes_of(t.v));
    assign_quotient(value, static_cast<std::int64_t>(sum), denominator,
                    row.greatest.shares_prime_with(t.v) ? small_primes::any_primes : primes);
    return true;
}

/// The part of v whose primes may divide N: the primes of the largest coefficient.
std::uint64_t suspected_part(std::uint64_t v, const PrimeParts& greatest) {
    if (greatest.primes == small_primes::any_primes || greatest.shares_prime_with(v)) return v;
    std::uint64_t rest = v >> std::countr_zero(v);
    small_primes::for_each(greatest.primes, [&](const small_primes::Prime& prime) {
        while (prime.divides(rest)) rest *= prime.inverse;
    });
    return v / rest;
}

/// Sets the factors of the denominator that may share primes with the numerator, and returns the part of v
/// whose power remains.
std::uint64_t set_denominators(const Forms& form, const FormRow& row, const WordParameter& t,
                               DenominatorWords& denominators) {
    for (const std::uint64_t factor : form.denominators)
        denominators.multiply(factor, form.denominator_primes);
    const std::uint64_t suspected = suspected_part(t.v, row.greatest);
    if (suspected != 1) {
        const bool all = row.greatest.shares_prime_with(t.v);
        const small_primes::Set primes = all ? small_primes::any_primes : row.greatest.primes;
        for (std::size_t left = form.degree; left > 0;) {
            std::uint64_t power = 1;
            for (std::uint64_t next = 1; left > 0 && !__builtin_mul_overflow(power, suspected, &next); --left)
                power = next;
            denominators.multiply(power, primes);
        }
    }
    return t.v / suspected;
}

/// Whether the denominators fit in the words that the fast path provides.
bool has_room(const Forms& form, const WordParameter& t) {
    const std::size_t words_of_power = form.degree * static_cast<std::size_t>(std::bit_width(t.v)) / 32 + 1;
    return form.denominators.size() + words_of_power <= DenominatorWords::most_words;
}

void assign_quotient(const Forms& form, const FormRow& row, const WordParameter& t,
                     std::span<std::uint64_t> magnitude, bool negative, Rational& value) {
    DenominatorWords denominators;
    const std::uint64_t rest = set_denominators(form, row, t, denominators);
    std::size_t used = magnitude.size();
    while (used > 1 && magnitude[used - 1] == 0) --used;
    assign_quotient(value, magnitude.first(used), negative, denominators, {});
    if (rest != 1 && !value.is_zero())
        RationalAccess::multiply_denominator(value, pow(Integer(rest), form.degree));
}

bool set_in_limbs(const Forms& form, const FormRow& row, const WordParameter& t, Rational& value) {
    const std::size_t bits = form.sum_bits + form.degree * t.bits + 1;
    if (form.denominators.empty() || !has_room(form, t)) return false;
    if (!row.words.empty() && bits < 128) {
        UInt128 power = 0;
        const auto sum = static_cast<Int128>(form_in(row.words, t, power));
        const UInt128 size = magnitude(sum);
        std::uint64_t words[] = {static_cast<std::uint64_t>(size), static_cast<std::uint64_t>(size >> 64)};
        assign_quotient(form, row, t, words, sum < 0, value);
        return true;
    }
    if (row.limbs.empty() || bits > 64 * FormLimbs::most_words) return false;
    std::uint64_t words[FormLimbs::most_words];
    const std::span<std::uint64_t> numerator = std::span(words).first(bits / 64 + 1);
    const bool negative = row.limbs.evaluate(t.u, static_cast<std::int64_t>(t.v), numerator);
    assign_quotient(form, row, t, numerator, negative, value);
    return true;
}

/// Not inlined, so that values of few words do not pay for its registers and memory.
[[gnu::noinline]] void set_beyond_words(const Forms& form, const FormRow& row, const WordParameter& t,
                                        Rational& value) {
    if (!set_in_limbs(form, row, t, value)) value = row.value_by_halves(t.u, t.v);
}

}  // namespace

PrimeParts::PrimeParts(const Integer& value) : rest(abs(value)) {
    if (value.is_zero()) {
        primes = small_primes::any_primes;
        return;
    }
    while (!rest.is_odd()) rest >>= 1;
    for (std::size_t i = 0; i < small_primes::count && !rest.is_one(); ++i) {
        const Integer prime = small_primes::table.primes[i].prime;
        while ((rest % prime).is_zero()) {
            rest = divide_exactly(rest, prime);
            primes |= small_primes::Set{1} << i;
        }
    }
    rest_word = static_cast<std::uint64_t>(rest.to_int64().value_or(0));
}

FormRow::FormRow(std::span<const Integer> coefficients, std::span<const std::int64_t> all_words,
                 const Integer& denominator)
    : words(all_words),
      greatest(coefficients.back()),
      limbs(greatest_bit_length(coefficients) <= 64 * FormLimbs::most_coefficient_words
                ? FormLimbs(coefficients)
                : FormLimbs()),
      coefficients_(coefficients),
      denominator_(denominator) {}

Rational FormRow::value_by_halves(const Integer& u, const Integer& v) const {
    const bool prepared = evaluations_.fetch_add(1, std::memory_order_relaxed) >= coefficients_.size();
    const auto make = [&] { return EvaluationByHalves(coefficients_, denominator_, prepared); };
    return (prepared ? prepared_ : plain_).value(make).value(u, v);
}

PreparedPolynomial::Forms::Forms(RationalVector given, std::size_t row_count)
    : numbers(std::move(given)), degree(numbers.size() / row_count - 1) {
    const std::size_t size = degree + 1;
    const std::size_t bits = greatest_bit_length(numbers.numerators());
    sum_bits = bits + static_cast<std::size_t>(std::bit_width(size));
    if (const auto word = numbers.denominator().to_int64())
        word_denominator = static_cast<std::uint64_t>(*word);
    if (const DenominatorParts split = split_denominator(numbers, true); split.longer.empty()) {
        denominators = split.words;
        if (denominators.empty()) denominators.push_back(1);
    }
    const PrimeParts parts(numbers.denominator());
    denominator_primes = parts.rest.is_one() ? parts.primes : small_primes::any_primes;
    if (bits < 64) {
        words.reserve(numbers.size());
        for (const Integer& number : numbers.numerators()) words.push_back(*number.to_int64());
    }
    for (std::size_t begin = 0; begin < numbers.size(); begin += size) {
        rows.emplace_back(
            std::span(numbers.numerators()).subspan(begin, size),
            words.empty() ? std::span<const std::int64_t>() : std::span(words).subspan(begin, size),
            numbers.denominator());
    }
}

PreparedPolynomial::PreparedPolynomial(RationalVector numbers, std::size_t rows)
    : prepared_(std::make_shared<const Forms>(std::move(numbers), rows)) {}

std::size_t PreparedPolynomial::rows() const { return prepared_->rows.size(); }

std::size_t PreparedPolynomial::degree() const { return prepared_->degree; }

std::size_t PreparedPolynomial::value_bits(std::size_t bits_of_t) const {
    return std::max(prepared_->sum_bits, prepared_->numbers.denominator().bit_length()) +
           degree() * bits_of_t;
}

void PreparedPolynomial::evaluate(std::int64_t numerator, std::int64_t denominator,
                                  std::span<Rational> values) const {
    const WordParameter t(numerator, static_cast<std::uint64_t>(denominator));
    auto row = prepared_->rows.begin();
    for (Rational& value : values) {
        if (!set_in_word(*prepared_, *row, t, value)) set_beyond_words(*prepared_, *row, t, value);
        ++row;
    }
}

void PreparedPolynomial::evaluate(const Rational& t, std::span<Rational> values) const {
    const auto u = t.numerator().to_int64();
    const auto v = t.denominator().to_int64();
    if (u && v && *u != std::numeric_limits<std::int64_t>::min()) return evaluate(*u, *v, values);
    for (std::size_t j = 0; j < values.size(); ++j)
        values[j] = prepared_->rows[j].value_by_halves(t.numerator(), t.denominator());
}

}  // namespace blossom
