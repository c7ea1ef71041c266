#pragma once

#include <QByteArray>
#include <QHash>
#include <QString>

#include <optional>

namespace halbench::app {

/// Why a kept arrangement of the panels cannot be shown.
enum class ArrangementFault { Damaged, Newer, Older };

/// Nothing for one that is whole and of this version; what it holds is not looked at.
std::optional<ArrangementFault> faultOf(const QByteArray& arrangement, int version);

/// A free name for one of this perspective that cannot be shown.
QString unreadName(const QHash<QString, QByteArray>& arrangements, const QString& perspective);

} // namespace halbench::app
