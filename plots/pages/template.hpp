#pragma once

#include <string_view>

namespace rockstack::plots {

// The files of plots/pages/templates/, with {{places}} to fill.

/// What all pages share: the frame around their content, style sheet and script.
extern const std::string_view page_html;
extern const std::string_view page_css;
extern const std::string_view page_js;

/// The contents of the pages, and what a lesson's style sheet has beyond the others'.
extern const std::string_view report_html;
extern const std::string_view study_html;
extern const std::string_view canon_html;
extern const std::string_view impact_laws_html;
extern const std::string_view lesson_css;

/// One player, and the style sheet and script of all players on a page.
extern const std::string_view player_html;
extern const std::string_view player_css;
extern const std::string_view player_js;

}  // namespace rockstack::plots
