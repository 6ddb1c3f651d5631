#pragma once

#include "plots/drawing/panel.hpp"

namespace rockstack::plots {

/// The numbers of a panel's data blocks as curves, with the words of their legend, their row or their panel,
/// or of none of these the block's name; of blocks with more than two columns a curve for each further one.
/// Without those that `known` panels tell already. `blocks`: all of the sheet, as data_block() writes them.
DrawnPanel told_of(const SidePanel& panel, const std::string& blocks, const Legend& legend,
                   const std::vector<DrawnPanel>& known);

}  // namespace rockstack::plots
