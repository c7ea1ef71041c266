#pragma once

#include <QStringList>

class QWidget;

namespace halbench::gui {

/// Words that are left out ("…") or cells that are cut while what is missing would find room beside them: in
/// the free part of the label's own row, or behind the last column of the table. What is cut because
/// everything around it is full is none of these. One line each.
QStringList needlessCuts(const QWidget& widget);

} // namespace halbench::gui
