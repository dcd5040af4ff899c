// Texts of submissions, made fit for a file.
#pragma once

#include <string>
#include <string_view>

namespace raylab {

// At most `bytes`, cut between two characters of UTF-8, with a word that something is missing.
std::string shortened(const std::string& text, std::size_t bytes);

// Valid UTF-8 without control characters except tab and line break: each other byte becomes U+FFFD.
std::string clean_utf8(std::string_view text);

// Text as it may stand between tags and inside quoted attributes.
std::string escape_html(std::string_view text);

// clean_utf8() as it may stand in XML, between tags and in attributes.
std::string escape_xml(std::string_view text);

// The message of an annotation in GitHub's log, or one of its properties: file, title.
std::string escape_github(std::string_view text, bool is_property);

// clean_utf8() as a field of CSV, in quotes and on one line (RFC 4180). A spreadsheet takes a text
// that begins with one of "=+-@" for a formula, so such a text gets an apostrophe before it.
std::string csv_field(std::string_view text);

} // namespace raylab
