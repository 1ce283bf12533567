#include "limit_table.hpp"

#include <limits>

namespace blossom::protocol {

namespace {

constexpr std::size_t any = std::numeric_limits<std::size_t>::max() / 4;
// Deeper values would exhaust the stack of a thread when they are written or destroyed.
constexpr std::size_t safe_nesting = 1'000;

constexpr LimitEntry table[] = {
    {"degree", &Limits::degree, "formal degree of a map, order of a derivative, and exponents in text", any},
    {"digits", &Limits::digits, "decimal digits of one number, read or computed", any},
    {"nesting", &Limits::nesting, "depth of nested brackets, in text and in JSON", safe_nesting},
    {"variables", &Limits::variables, "variables of one polynomial", any},
    {"polarization_terms", &Limits::polarization_terms, "terms of one polarization sum", any},
    {"regrouping_work", &Limits::regrouping_work, "multiply-adds of one regrouped polarization", any},
    {"expansion_terms", &Limits::expansion_terms, "terms of one polynomial in several variables", any},
    {"expansion_work", &Limits::expansion_work, "term operations of one symbolic computation", any},
    {"numbers", &Limits::numbers, "numbers that make up one map or one result", any},
    {"output_digits", &Limits::output_digits, "decimal digits of one whole result", any},
    {"line_bytes", &Limits::line_bytes, "bytes of one line of a batch, or of one file or argument", any},
    {"work", &Limits::work, "word operations of one request", any},
    {"memory", &Limits::memory, "bytes that one request takes at once", any},
    {"timeout", &Limits::timeout, "seconds of processor time of one request; 0 for no limit", any},
};

static_assert(sizeof table / sizeof *table == sizeof(Limits) / sizeof(std::size_t), "one entry per limit");

}  // namespace

std::span<const LimitEntry> limit_table() { return table; }

}  // namespace blossom::protocol
