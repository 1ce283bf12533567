#include <blossom/core/geometry/affine_map.hpp>
#include <blossom/rational/error.hpp>

#include <string>
#include <utility>

namespace blossom::geometry {

AffineMap::AffineMap(Simplex domain, std::vector<Point> images)
    : domain_(std::move(domain)), images_(std::move(images)) {
    if (images_.size() != domain_.vertices().size()) {
        throw Error(ErrorCode::wrong_arity,
                    "an affine map on a simplex with " + std::to_string(domain_.vertices().size()) +
                        " vertices needs as many images, not " + std::to_string(images_.size()));
    }
    for (const Point& image : images_) require_same_space(range(), image.space());
}

Point AffineMap::operator()(const Point& point) const {
    return affine_combination(images_, domain_.barycentric(point));
}

Vector AffineMap::operator()(const Vector& vector) const {
    const Coordinates weights = domain_.barycentric(vector);
    Vector image = range().vector(Coordinates(range().dimension()));
    for (std::size_t i = 0; i < weights.size(); ++i)
        image = image + weights[i] * (images_[i] - images_.front());
    return image;
}

AffineMap composed(const AffineMap& second, const AffineMap& first) {
    std::vector<Point> images;
    for (const Point& image : first.images()) images.push_back(second(image));
    return {first.domain(), std::move(images)};
}

}  // namespace blossom::geometry
