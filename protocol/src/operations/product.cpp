#include <fmt/format.h>

#include "common_domain.hpp"
#include "listing.hpp"
#include "map_list.hpp"
#include "map_options.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

enum class ProductForm { scalar, dot, cross, determinant };

constexpr std::string_view product_names[] = {"scalar", "dot", "cross", "determinant"};

/// Errors: `wrong_arity` at "maps".
void require_factors(std::size_t given, std::size_t needed, ProductForm form, std::size_t dimension) {
    if (given == needed) return;
    throw Error(ErrorCode::wrong_arity,
                fmt::format("a {} product in dimension {} is one of {} maps, not of {}",
                            product_names[static_cast<std::size_t>(form)], dimension, needed, given),
                Place{"maps"});
}

CoordinateSums product_sums(const CommonMaps& given, ProductForm form, const Limits& limits) {
    const std::size_t count = given.size();
    if (form == ProductForm::scalar) {
        std::vector<std::size_t> dimensions;
        for (std::size_t i = 0; i < count; ++i) dimensions.push_back(given.dimension(i));
        return scalar_multiple(dimensions);
    }
    require_points_alike(given);
    const std::size_t dimension = given.dimension(0);
    switch (form) {
        case ProductForm::dot:
            require_factors(count, 2, form, dimension);
            return dot_product(dimension);
        case ProductForm::cross:
            require_factors(count, dimension - 1, form, dimension);
            return cross_product(dimension, limits);
        default:
            require_factors(count, dimension, form, dimension);
            return determinant(dimension, limits);
    }
}

Answer answer_product(Request& request, const Limits& limits) {
    const std::vector<Map> maps = read_maps_field(request, limits);
    const auto form = static_cast<ProductForm>(
        request
            .optional("as",
                      [](const Json& value) { return read_alternative(value, product_names, "a product"); })
            .value_or(0));
    request.finish();
    const CommonMaps given = on_common_domain(maps, limits);
    const CoordinateSums sums = product_sums(given, form, limits);
    const bool scalar = form == ProductForm::scalar ? std::ranges::all_of(given.forms, &PointForm::scalar)
                                                    : form != ProductForm::cross;
    return answer_of(combined_map(given, sums, scalar, limits), "maps");
}

}  // namespace

Operation product_operation() {
    return {
        .summary =
            "Multiply maps on one domain: with scalar maps, or by a dot or cross product or determinant",
        .documentation = "The degrees add up; splines get the knots of all.",
        .request = {{maps_field("the factors, of any kinds on one domain"),
                     optional("as", Shape::words(product_names),
                              "`scalar`, the default: of maps of which all but one are scalar; `dot`: of two "
                              "maps; `cross`: of n - 1 maps into dimension n; `determinant`: of n maps into "
                              "dimension n")}},
        .result = {{map_member("the product")}},
        .example = {"product", "1 + t; t^2; t", "t; 1; 2t", "--as", "cross"},
        .options = {maps_option("MAP",
                                "the factors: polynomials, maps of the protocol, lists of them, or the "
                                "output of other commands"),
                    word_option("--as", "as")},
        .answer = answer_product,
        .render = described_listing,
        .plot = plot_of_result,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
