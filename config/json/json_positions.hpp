// Where things stand in the text of a JSON file.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace rigsound::config {

constexpr std::size_t kNowhere = std::string_view::npos;

/// Offset of `"key"` in the object whose { is at or behind `object`, kNowhere when it has no such key.
std::size_t key_position(std::string_view text, std::size_t object, std::string_view key);

/// Offsets of the items of the list whose [ is at or behind `list`, as far as they are objects.
std::vector<std::size_t> item_positions(std::string_view text, std::size_t list);

/// Lines count from 1.
int line_at(std::string_view text, std::size_t position);

}  // namespace rigsound::config
