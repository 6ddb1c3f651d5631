#pragma once

#include <filesystem>

namespace rockstack::plots {

/// Prints a page by the program `chromium`, the paper as the page's style says. The file appears whole or not
/// at all.
/// @throws InputError where there is no such program, std::runtime_error where it fails.
void print_pdf(const std::filesystem::path& page, const std::filesystem::path& pdf);

}  // namespace rockstack::plots
