#pragma once

#include <string_view>

namespace rockstack::plots {

// The files of plots/pages/course/templates/, with {{places}} to fill; style sheets and scripts have none.
extern const std::string_view lesson_html;
extern const std::string_view lesson_js;
extern const std::string_view slides_html;
extern const std::string_view slides_css;
extern const std::string_view slides_js;
extern const std::string_view course_html;
extern const std::string_view sheet_html;
extern const std::string_view sheet_css;

}  // namespace rockstack::plots
