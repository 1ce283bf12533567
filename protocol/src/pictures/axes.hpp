#pragma once

#include <blossom/rational/rational.hpp>

#include <string>

#include "frame.hpp"
#include "svg_document.hpp"

namespace blossom::protocol {

/// A short decimal, or the fraction where it has none.
std::string tick_text(const Rational& tick);

/// Lines at round numbers, with these numbers below and to the left.
void paint_axes(SvgDocument& svg, const Frame& frame);

}  // namespace blossom::protocol
