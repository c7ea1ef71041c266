#pragma once

#include "widgets/theme/theme_style.h"

#include <QIcon>
#include <QString>
#include <QStringList>

namespace halbench::widgets {

/// The icon of that name (resources/icons/NAME.svg), drawn in the role's colour of the theme that is current
/// when it is drawn: a new theme needs no new icons. An unknown name gives a null icon.
QIcon themedIcon(const QString& name, Role role = Role::None);

/// As above in a fixed colour, e.g. that of the words on a filled button.
QIcon colouredIcon(const QString& name, const QColor& colour);

/// Every icon there is.
QStringList iconNames();

} // namespace halbench::widgets
