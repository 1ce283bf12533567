#pragma once

#include <blossom/worked/document.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace blossom::worked {

/// The topics, number and difficulty of a sheet, whose problems are on the topics in turn.
struct SheetRequest {
    std::vector<std::string> topics;
    std::uint64_t seed = 1;
    std::size_t count = 5;
    std::size_t level = 1;  ///< 1 to 3: degree 2, degree 3, degree 3 with fractions
};

/// A sheet of problems, and the same problems with their worked solutions.
struct Sheet {
    Document problems;
    Document solutions;
};

/// The topics in the order of the chapters.
std::vector<std::string_view> exercise_topics();

/// Errors: `unknown_op` for an unknown topic.
void require_topic(std::string_view name);

/// Problems with small numbers, which depend on the seed, the level and the topic, no two alike, none
/// degenerate: leading coefficients are not zero, parameters are not ends of intervals, control polygons do
/// not lie on a line. The same request gives the same sheet on every platform. Errors: `unknown_op` for an
/// unknown topic; `wrong_arity` for no topic, for fewer problems than topics and for another level;
/// `limit_exceeded` for more than `most_problems`.
Sheet exercise_sheet(const SheetRequest& request);
constexpr std::size_t most_problems = 40;

}  // namespace blossom::worked
