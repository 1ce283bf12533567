#pragma once

#include <blossom/rational/limits.hpp>
#include <blossom/worked/document.hpp>
#include <blossom/worked/notation.hpp>

#include <optional>
#include <string>
#include <vector>

#include "json/fields.hpp"
#include "operations/operation.hpp"

namespace blossom::protocol {

/// How a request wants documents written: its fields "format", "notation", "multiplicities" and "columns".
class DocumentFormat {
public:
    /// Errors: `wrong_kind` for a format or a notation that is not known.
    static DocumentFormat read(Fields& request, const Limits& limits);

    /// The fields "format" and "document" of a result, of one or more documents that follow each other.
    Json written(const std::vector<worked::Document>& documents) const;

private:
    std::string format_;
    std::optional<worked::BlossomStyle> style_;
    std::optional<bool> multiplicities_;
    std::size_t columns_ = 0;
};

/// These fields, and the members of the result.
FieldList document_fields();
Members document_members();

/// The options that write these fields.
std::vector<Option> document_options();

/// The document of a result.
std::string document_text(const Answered& answered);

}  // namespace blossom::protocol
