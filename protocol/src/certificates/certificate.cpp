#include "certificate.hpp"

#include <fmt/format.h>
#include <blossom/rational/lists.hpp>
#include <blossom/rational/number_text.hpp>
#include <blossom/rational/rational_vector.hpp>

#include <algorithm>
#include <cstdint>

#include "maps/points.hpp"

namespace blossom::protocol {

namespace {

constexpr std::string_view header =
    "(* Values of blossoms, to be checked by computation. With the theories of blossom\n"
    "   compiled by scripts/prove; proofs/coq/stream.v says what the words mean:\n"
    "     coqc -R build/coq Blossom FILE.v *)\n"
    "From Coq Require Import Uint63.\n"
    "From mathcomp Require Import ssreflect seq.\n"
    "From Blossom Require Import stream.\n";

constexpr std::size_t word_bits = 60;
constexpr std::size_t words_a_line = 5;
constexpr std::size_t words_a_list = 200;  // Coq parses long lists recursively

/// Integers as the machine words that `read` of stream.v takes apart.
class Words {
public:
    explicit Words(const Limits& limits) : limits_(limits) {}

    void append(const Integer& value) {
        constexpr std::size_t small_bits = 58;
        const std::uint64_t sign = value.sign() < 0 ? 2 : 0;
        Integer magnitude = abs(value);
        if (magnitude.bit_length() <= small_bits) {
            push(4 * word(magnitude) + sign);
            return;
        }
        const std::size_t length = (magnitude.bit_length() + word_bits - 1) / word_bits;
        push(4 * length + sign + 1);
        const Integer base = Integer(1) << word_bits;
        for (std::size_t i = 0; i < length; ++i) {
            push(word(magnitude % base));
            magnitude >>= word_bits;
        }
    }

    std::string text() const {
        std::string lists;
        for (std::size_t i = 0; i < words_.size(); ++i) {
            const bool first = i % words_a_list == 0;
            const std::string_view line = i % words_a_line == 0 ? "\n     " : " ";
            if (first && i > 0) lists += "];\n   ";
            lists += fmt::format("{}{}{}", first ? "[::" : ";", first ? " " : line, words_[i]);
        }
        return "[:: " + lists + "]]";
    }

private:
    static std::uint64_t word(const Integer& value) { return static_cast<std::uint64_t>(*value.to_int64()); }

    void push(std::uint64_t value) {
        constexpr std::size_t word_digits = 19;
        words_.push_back(value);
        require_within(words_.size() * word_digits, limits_.output_digits, "output_digits",
                       "the size of the certificate in decimal digits, at most");
    }

    const Limits& limits_;
    std::vector<std::uint64_t> words_;
};

void append_value(Words& words, const CertifiedValue& value, std::size_t coordinate) {
    for (const Argument& argument : value.arguments) {
        const Integer scale = lcm(argument.u.denominator(), argument.mass.denominator());
        words.append((argument.u * scale).numerator());
        words.append((argument.mass * scale).numerator());
        words.append(scale);
    }
    words.append(value.multiple);
    words.append(value.value[coordinate].numerator());
    words.append(value.value[coordinate].denominator());
}

void append_map(Words& words, const CertifiedMap& map, std::size_t coordinate) {
    std::vector<Rational> column;
    for (const Coordinates& point : map.curve.coefficients().to_points()) column.push_back(point[coordinate]);
    const RationalVector coefficients(column);
    words.append(map.curve.degree());
    words.append(coefficients.denominator());
    for (const Integer& numerator : coefficients.numerators()) words.append(numerator);
    words.append(map.values.size());
    for (const CertifiedValue& value : map.values) append_value(words, value, coordinate);
}

std::string words_text(const Certificate& certificate, const Limits& limits) {
    std::size_t coordinates = 0;
    for (const CertifiedMap& map : certificate.maps) coordinates += map.curve.dimension();
    Words words(limits);
    words.append(coordinates);
    for (const CertifiedMap& map : certificate.maps) {
        for (std::size_t j = 0; j < map.curve.dimension(); ++j) append_map(words, map, j);
    }
    return words.text();
}

std::string point_text(const Coordinates& point) {
    const std::string text = joined(point, [&](const Rational& coordinate) { return to_string(coordinate); });
    return point.size() == 1 ? text : "(" + text + ")";
}

std::string argument_text(const Argument& argument) {
    if (argument.mass == Rational(1)) return to_string(argument.u);
    if (argument == Argument(delta)) return "delta";
    return "(" + to_string(argument.u) + ", " + to_string(argument.mass) + ")";
}

/// Equal neighbours are counted: "0 (3 times), delta".
std::string arguments_text(std::span<const Argument> arguments) {
    std::string text;
    for (std::size_t i = 0, next = 0; i < arguments.size(); i = next) {
        while (next < arguments.size() && arguments[next] == arguments[i]) ++next;
        text += (text.empty() ? "" : ", ") + argument_text(arguments[i]);
        if (next - i > 1) text += fmt::format(" ({} times)", next - i);
    }
    return text;
}

std::string comment(const CertifiedMap& map) {
    std::string text = fmt::format("\n   P has degree {} and the coefficients", map.curve.degree());
    for (const Coordinates& point : map.curve.coefficients().to_points()) text += " " + point_text(point);
    for (const CertifiedValue& value : map.values) {
        const std::string multiple = value.multiple.is_one() ? "" : to_string(value.multiple) + " ";
        text += fmt::format("\n   {} = {}p[{}] = {}", value.name, multiple, arguments_text(value.arguments),
                            point_text(value.value));
    }
    return text;
}

std::string comment(const Certificate& certificate) {
    std::string text = "(* " + certificate.title;
    for (const CertifiedMap& map : certificate.maps) text += comment(map);
    return text + " *)\n";
}

void require_size(const Certificate& certificate, const Limits& limits) {
    for (const CertifiedMap& map : certificate.maps) {
        const std::size_t numbers_a_value = 3 * map.curve.degree() + 3;
        require_numbers(map.values.size() * numbers_a_value, map.curve.dimension(), limits);
    }
}

}  // namespace

std::string coq_file(std::span<const Certificate> certificates, const Limits& limits) {
    std::string text(header);
    for (std::size_t i = 0; i < certificates.size(); ++i) {
        require_size(certificates[i], limits);
        const std::string name = fmt::format("request_{}", i + 1);
        text += fmt::format(
            "\n{0}Definition {1} : seq words :=\n  {2}%uint63.\n\n"
            "Definition {1}_holds : certified {1} :=\n  checked (Logic.eq_refl true <: check_stream {1} = "
            "true).\n",
            comment(certificates[i]), name, words_text(certificates[i], limits));
    }
    return text;
}

}  // namespace blossom::protocol
