#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>
#include <blossom/rational/utf8.hpp>
#include <blossom/rational/written_marks.hpp>

#include <algorithm>
#include <limits>

namespace blossom {

namespace {

constexpr std::size_t unbounded = std::numeric_limits<std::size_t>::max();

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool starts_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::size_t saturating_product(std::size_t a, std::size_t b) {
    std::size_t product = 0;
    return __builtin_mul_overflow(a, b, &product) ? unbounded : product;
}

/// Predicts the cost of a product or a power, and refuses it beyond the limits before it is computed.
class Budget {
public:
    explicit Budget(const Limits& limits) : limits_(limits) {}

    SparsePolynomial product(const SparsePolynomial& a, const SparsePolynomial& b) {
        require_degree(a.total_degree(), 1, b.total_degree());
        const std::size_t pairs = saturating_product(a.size(), b.size());
        require_terms(std::min(pairs, box(a, 1, &b)));
        require_work(pairs);
        require_bits(bits(a) + bits(b));
        return a * b;
    }

    SparsePolynomial power(const SparsePolynomial& base, std::size_t exponent) {
        require_degree(base.total_degree(), exponent, 0);
        require_bits(saturating_product(bits(base), exponent));
        require_terms(std::min(box(base, exponent, nullptr), multinomial_terms(base.size(), exponent)));
        if (base.size() > 2) {
            const std::size_t half = exponent / 2 + 1;
            const std::size_t terms =
                std::min(box(base, half, nullptr), multinomial_terms(base.size(), half));
            require_work(saturating_product(terms, terms));
        }
        return pow(base, exponent);
    }

    /// By halves, because different denominators multiply.
    SparsePolynomial sum(std::span<const SparsePolynomial> summands) const {
        if (summands.size() == 1) return summands.front();
        const std::size_t half = summands.size() / 2;
        const SparsePolynomial a = sum(summands.first(half));
        const SparsePolynomial b = sum(summands.subspan(half));
        if (a.coefficients().denominator() != b.coefficients().denominator()) require_bits(bits(a) + bits(b));
        return a + b;
    }

    void require_terms(std::size_t terms) const {
        require_within(terms, limits_.expansion_terms, "expansion_terms", "the number of terms, up to");
    }

private:
    static std::size_t bits(const SparsePolynomial& polynomial) {
        return greatest_bit_length(polynomial.coefficients().numerators()) +
               polynomial.coefficients().denominator().bit_length();
    }

    /// The number of monomials whose exponents are at most those of base^exponent * other.
    static std::size_t box(const SparsePolynomial& base, std::size_t exponent,
                           const SparsePolynomial* other) {
        std::size_t size = 1;
        const std::size_t variables = std::max(base.variables(), other ? other->variables() : 0);
        for (std::size_t i = 0; i < variables; ++i) {
            const std::size_t degree = base.degree_in(i) * exponent + (other ? other->degree_in(i) : 0);
            size = saturating_product(size, degree + 1);
        }
        return size;
    }

    /// C(exponent + terms - 1, terms - 1), or `unbounded` if it exceeds the limit.
    std::size_t multinomial_terms(std::size_t terms, std::size_t exponent) const {
        if (terms <= 1) return terms;
        if (terms - 1 > limits_.expansion_terms || exponent > limits_.expansion_terms) {
            return exponent < 2 ? terms : unbounded;
        }
        Integer count = 1;
        for (std::size_t i = 1; i < terms; ++i) {
            count = divide_exactly(count * Integer(exponent + i), Integer(i));
            if (count > Integer(limits_.expansion_terms)) return unbounded;
        }
        return static_cast<std::size_t>(*count.to_int64());
    }

    void require_degree(std::size_t degree, std::size_t exponent, std::size_t more) const {
        const std::size_t product = saturating_product(degree, exponent);
        require_within(product == unbounded ? product : product + more, limits_.degree, "degree",
                       "the degree");
    }
    void require_bits(std::size_t bits) const {
        require_within(bits / 3, limits_.digits, "digits", "the decimal digits of a coefficient, up to");
    }
    void require_work(std::size_t work) {
        work_ = work == unbounded ? work : work_ + work;
        require_within(work_, limits_.expansion_work, "expansion_work",
                       "the number of term operations, up to");
    }

    const Limits& limits_;
    std::size_t work_ = 0;
};

class Reader {
public:
    Reader(std::string_view text, std::span<const std::string> names, const Limits& limits)
        : text_(text),
          names_(names.begin(), names.end()),
          free_names_(names.empty()),
          limits_(limits),
          budget_(limits) {}

    NamedPolynomial read() {
        SparsePolynomial polynomial = expression();
        if (!at_end()) fail("an operator or the end");
        return {std::move(polynomial), std::move(names_)};
    }

private:
    bool at_end() {
        while (position_ < text_.size() && is_space(text_[position_])) ++position_;
        return position_ == text_.size();
    }
    std::string_view rest() const { return text_.substr(position_); }
    /// The meaning of the next mark that is not white space, or 0 at the end.
    char peek() { return at_end() ? '\0' : written_mark(rest()).meaning; }
    bool accept(char c) {
        if (peek() != c) return false;
        position_ += written_mark(rest()).length;
        return true;
    }
    /// Whether a number begins here, where `next` is the next mark.
    bool begins_number(char next) const {
        if (is_digit(next)) return true;
        const bool may_begin = next == '.' || static_cast<unsigned char>(next) >= 0x80;
        return may_begin && unsigned_number_length(rest()) > 0;
    }

    [[noreturn]] void refuse(const Error& error, std::size_t position) const {
        const std::size_t column = count_characters(text_.substr(0, position)) + 1;
        throw error.at(Place()).at(position).saying("column " + std::to_string(column) + ": " +
                                                    error.message());
    }
    [[noreturn]] void fail_at(std::size_t position, ErrorCode code, const std::string& message) const {
        refuse(Error(code, message), position);
    }
    [[noreturn]] void fail(const std::string& expected) {
        const std::string found = at_end() ? "the end" : quoted(first_character(rest()));
        fail_at(position_, ErrorCode::syntax, "expected " + expected + ", found " + found);
    }
    /// Runs an operation on the expression that begins at `position`, and adds this position to the error if
    /// a limit stops it.
    template <class Operation>
    auto at(std::size_t position, Operation operation) const {
        try {
            return operation();
        } catch (const Error& error) {
            refuse(error, position);
        }
    }

    SparsePolynomial expression() {
        std::vector<SparsePolynomial> terms;
        const std::size_t begin = position_;
        const bool negative = accept('-') || (accept('+'), false);
        terms.push_back(signed_term(negative));
        for (char sign = peek(); sign == '+' || sign == '-'; sign = peek()) {
            const std::size_t start = position_;
            accept(sign);
            const bool minus = accept('-');
            at(start, [&] {
                budget_.require_terms(terms.size() + 1);
                return 0;
            });
            terms.push_back(signed_term((sign == '-') != minus));
        }
        return at(begin, [&] { return budget_.sum(terms); });
    }

    SparsePolynomial signed_term(bool negative) {
        SparsePolynomial value = term();
        return negative ? -value : value;
    }

    SparsePolynomial term() {
        SparsePolynomial value = power();
        while (true) {
            const char next = peek();
            const std::size_t start = position_;
            if (accept('/')) {
                const SparsePolynomial factor = reciprocal(start);
                value = at(start, [&] { return budget_.product(value, factor); });
            } else if (next == '*' || next == '(' || starts_name(next)) {
                accept('*');
                const SparsePolynomial factor = power();
                value = at(start, [&] { return budget_.product(value, factor); });
            } else if (begins_number(next)) {
                fail("an operator before a number");
            } else {
                return value;
            }
        }
    }

    Rational reciprocal(std::size_t slash) {
        const std::size_t start = position_;
        const SparsePolynomial divisor = power();
        if (divisor.is_zero()) fail_at(slash, ErrorCode::zero_denominator, "division by zero");
        if (divisor.total_degree() > 0) {
            fail_at(start, ErrorCode::syntax, "a polynomial is divided by constants only");
        }
        return Rational(1) / divisor.coefficient(0);
    }

    SparsePolynomial power() {
        peek();
        const std::size_t start = position_;
        SparsePolynomial base = primary();
        const bool is_raised = at_superscript();
        if (!is_raised && !accept('^')) return base;
        const std::size_t exponent = is_raised ? raised_number() : natural_number();
        if (peek() == '^' || at_superscript()) fail("an operator; write (a^b)^c or a^(b*c) out");
        return at(start, [&] { return budget_.power(base, exponent); });
    }

    bool at_superscript() {
        return static_cast<unsigned char>(peek()) >= 0x80 && superscript(rest()).length > 0;
    }

    std::size_t raised_number() {
        const Superscript raised = superscript(rest());
        if (raised.digits.starts_with('-')) fail("an exponent, a number without sign");
        const std::size_t start = position_;
        position_ += raised.length;
        return exponent(start, raised.digits);
    }

    std::size_t natural_number() {
        if (!is_digit(peek())) fail("an exponent, a number without sign");
        const std::size_t start = position_;
        while (position_ < text_.size() && is_digit(text_[position_])) ++position_;
        return exponent(start, text_.substr(start, position_ - start));
    }

    std::size_t exponent(std::size_t start, std::string_view digits) const {
        return at(start, [&] {
            const auto value = parse_integer(digits, limits_).to_int64();
            if (!value || std::cmp_greater(*value, limits_.degree)) {
                throw limit_error("the exponent " + std::string(digits.substr(0, 40)) + " exceeds", "degree",
                                  limits_.degree);
            }
            return static_cast<std::size_t>(*value);
        });
    }

    SparsePolynomial primary() {
        const char next = peek();
        const std::size_t start = position_;
        if (starts_name(next)) return variable();
        if (begins_number(next)) {
            const std::size_t length = unsigned_number_length(rest());
            position_ += length;
            const bool separates = rest().starts_with('_') && rest().size() > 1 && is_digit(rest()[1]);
            if (separates) fail("a number without '_' between its digits");
            return at(start,
                      [&] { return SparsePolynomial(parse_rational(text_.substr(start, length), limits_)); });
        }
        if (next != '(') fail("a number, a variable or '('");
        if (++depth_ > limits_.nesting) {
            refuse(limit_error("brackets nested deeper than", "nesting", limits_.nesting), start);
        }
        ++position_;
        SparsePolynomial value = expression();
        if (!accept(')')) fail("an operator or ')'");
        --depth_;
        return value;
    }

    SparsePolynomial variable() {
        const std::size_t start = position_;
        while (position_ < text_.size() && (starts_name(text_[position_]) || is_digit(text_[position_])))
            ++position_;
        const std::string name(text_.substr(start, position_ - start));
        auto place = std::ranges::find(names_, name);
        if (place == names_.end()) {
            if (!free_names_)
                fail_at(start, ErrorCode::syntax, "unknown variable " + quoted(name) + known_names());
            at(start, [&] {
                require_within(names_.size() + 1, limits_.variables, "variables", "the number of variables");
                return 0;
            });
            place = names_.insert(names_.end(), name);
        }
        return SparsePolynomial::variable(static_cast<std::size_t>(place - names_.begin()));
    }

    std::string known_names() const {
        std::string list;
        for (const std::string& name : names_) list += (list.empty() ? "; known: " : ", ") + name;
        return list;
    }

    std::string_view text_;
    std::vector<std::string> names_;
    bool free_names_;
    const Limits& limits_;
    Budget budget_;
    std::size_t position_ = 0;
    std::size_t depth_ = 0;
};

}  // namespace

NamedPolynomial parse_polynomial(std::string_view text, std::span<const std::string> names,
                                 const Limits& limits) {
    return Reader(text, names, limits).read();
}

UnivariateText univariate(const NamedPolynomial& read) {
    if (read.names.size() > 1) {
        throw Error(ErrorCode::syntax, "a polynomial in one variable is expected, and both " + read.names[0] +
                                           " and " + read.names[1] + " occur; write a product with '*'");
    }
    return {dense(read.polynomial), read.names.empty() ? "t" : read.names.front()};
}

UnivariateText parse_univariate(std::string_view text, const Limits& limits) {
    return univariate(parse_polynomial(text, {}, limits));
}

}  // namespace blossom
