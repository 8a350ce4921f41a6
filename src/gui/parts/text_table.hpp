#pragma once

#include "pmts/app/field/method_page.hpp"

class QTableWidget;

namespace pmts::gui {

/// Puts texts into a table: numbers to the right, the rows that sum up in bold.
void showTexts(QTableWidget& widget, const app::TextTable& texts);

}  // namespace pmts::gui
