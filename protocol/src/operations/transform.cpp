#include <fmt/format.h>

#include "common_domain.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// x -> matrix x + translation.
struct Transformation {
    std::vector<Coordinates> matrix;
    Coordinates translation;
    bool scalar = false;
};

/// Rows of numbers, or one row, which makes a scalar map.
std::pair<std::vector<Coordinates>, bool> read_matrix(const Json& value, std::size_t columns,
                                                      const Limits& limits) {
    const auto read_row = [&](const Json& row) {
        Coordinates numbers = read_numbers(row, limits);
        if (numbers.size() == columns) return numbers;
        throw Error(ErrorCode::mismatched_dimensions,
                    fmt::format("a row for points of {} coordinates has as many numbers, not {}", columns,
                                numbers.size()));
    };
    const Json::Array& rows = read_array(value);
    if (rows.empty()) throw Error(ErrorCode::wrong_arity, "a matrix has at least one row");
    if (!rows.front().array()) return {{read_row(value)}, true};
    return {read_list(value, read_row), false};
}

Transformation read_transformation(Fields& request, std::size_t dimension, bool scalar,
                                   const Limits& limits) {
    const auto matrix =
        request.optional("matrix", [&](const Json& value) { return read_matrix(value, dimension, limits); });
    Transformation result;
    if (matrix) {
        result.matrix = matrix->first;
        result.scalar = matrix->second || (scalar && result.matrix.size() == 1);
    } else {
        require_product_within({dimension, dimension}, limits.numbers, "numbers",
                               "the number of entries of a matrix");
        result.scalar = scalar;
        result.matrix.assign(dimension, Coordinates(dimension));
        for (std::size_t j = 0; j < dimension; ++j) result.matrix[j][j] = 1;
    }
    const std::size_t rows = result.matrix.size();
    const auto translation = request.optional("translation", [&](const Json& value) {
        Coordinates numbers =
            value.array() ? read_numbers(value, limits) : Coordinates{read_number(value, limits)};
        if (numbers.size() == rows) return numbers;
        throw Error(ErrorCode::mismatched_dimensions,
                    fmt::format("a translation has as many numbers as the result has coordinates, {}, not {}",
                                rows, numbers.size()));
    });
    if (!matrix && !translation) request.missing("matrix");
    result.translation = translation.value_or(Coordinates(rows));
    return result;
}

Answer answer_transform(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const CommonMaps given = on_own_domain(map, limits);
    const Transformation change = read_transformation(request, given.dimension(0), map.form.scalar, limits);
    request.finish();
    return answer_of(
        combined_map(given, affine_image(change.matrix, change.translation), change.scalar, limits));
}

Json matrix_of(std::string_view text) {
    return text.find(';') == std::string_view::npos ? number_list(text) : tuple_list(text);
}

}  // namespace

Operation transform_operation() {
    return {
        .summary = "Apply an affine map to the points of a map: a matrix and a translation",
        .documentation = "A single row is a linear functional of the coordinates and makes a scalar map.",
        .request = {{map_field(),
                     optional("matrix", Shape::one_of({numbers_shape(), tuples_shape()}),
                              "a row of numbers per coordinate of the result, or one row alone for a scalar "
                              "map; by default the identity"),
                     optional("translation", ValueKind::point,
                              "what is added, a number for a scalar map; by default 0")}},
        .result = {{map_member("the image")}},
        .example = {"transform", "--control-points", "0,0; 1,2; 3,0", "--matrix", "0,-1; 1,0",
                    "--translation", "5,0"},
        .options = with_map_options({
            field_option("--matrix", "matrix", "ROW;ROW;...", matrix_of),
            field_option("--translation", "translation", "X,Y,...", number_list),
        }),
        .answer = answer_transform,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
