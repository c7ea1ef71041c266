#include "app/window/docks/perspective.h"

#include <QCoreApplication>

#include <cstddef>

namespace halbench::app {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("Panels", text);
}

} // namespace

QString perspectiveTitle(Perspective perspective) {
    switch (perspective) {
    case Perspective::Monitor:
        return words(QT_TRANSLATE_NOOP("Panels", "Monitor"));
    case Perspective::Identify:
        return words(QT_TRANSLATE_NOOP("Panels", "Identify"));
    case Perspective::Tune:
        return words(QT_TRANSLATE_NOOP("Panels", "Tune"));
    case Perspective::Record:
        return words(QT_TRANSLATE_NOOP("Panels", "Record"));
    case Perspective::Field:
        break;
    }
    return words(QT_TRANSLATE_NOOP("Panels", "Field && Pose"));
}

QString perspectiveId(Perspective perspective) {
    constexpr const char* Ids[] = {"monitor", "identify", "tune", "record", "field"};
    return Ids[static_cast<std::size_t>(perspective)];
}

std::optional<Perspective> perspectiveOf(const QString& id) {
    for (const Perspective perspective : AllPerspectives) {
        if (perspectiveId(perspective) == id) {
            return perspective;
        }
    }
    return std::nullopt;
}

} // namespace halbench::app
