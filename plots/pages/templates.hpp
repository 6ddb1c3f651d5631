#pragma once

#include <string_view>

namespace rockstack::plots {

// The files of plots/pages/templates/ and plots/pages/course/templates/, by their names, with {{places}} to
// fill; style sheets and scripts have none.

/// What all pages share: the frame around their content, style sheet and script.
extern const std::string_view page_html, page_css, page_js;

/// The contents of the pages.
extern const std::string_view report_html, study_html, canon_html, impact_laws_html;

/// One player, and the style sheet and script of all players on a page.
extern const std::string_view player_html, player_css, player_js;

/// The course; lesson_css goes into every page.
extern const std::string_view lesson_html, lesson_css, lesson_js, slides_html, slides_css, slides_js,
    course_html, sheet_html, sheet_css;

}  // namespace rockstack::plots
