#pragma once

#include <QStringList>

class QWidget;

namespace halbench::gui {

/// Words that are left out ("…") or cells that are cut while what is missing would find room beside them: in
/// the free part of the label's own row, or behind the last column of the table. What is cut because
/// everything around it is full is none of these, but a number that the edge of its view cuts is: "100" of
/// "1001" is wrong, whatever is around it. One line each.
QStringList needlessCuts(const QWidget& widget);

} // namespace halbench::gui
