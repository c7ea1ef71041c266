#include "tests/widgets/gui_fixture.h"
#include "widgets/theme/icons.h"

#include <QImage>
#include <QPixmapCache>

namespace halbench::widgets {
namespace {

using Icons = GuiTest;

/// The colour of the most opaque pixel.
QColor inkOf(const QImage& image) {
    QColor ink = Qt::transparent;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (image.pixelColor(x, y).alpha() > ink.alpha()) {
                ink = image.pixelColor(x, y);
            }
        }
    }
    return ink;
}

bool isNear(const QColor& one, const QColor& other) {
    return std::abs(one.red() - other.red()) + std::abs(one.green() - other.green()) +
               std::abs(one.blue() - other.blue()) <
           24; // premultiplied 8-bit pixels round
}

TEST_F(Icons, coverTheVocabularyOfTheWindow) {
    for (const char* name :
         {"connect",  "disconnect", "arm",       "stop",     "record", "pause", "end",    "play",
          "follow",   "fit",        "cursor",    "trigger",  "whole",  "back",  "detach", "rate",
          "picture",  "add",        "remove",    "undo",     "redo",   "save",  "open",   "read",
          "write",    "search",     "filter",    "help",     "ok",     "error", "close",  "warning",
          "settings", "copy",       "simulated", "defaults", "revert"}) {
        EXPECT_FALSE(themedIcon(QLatin1String(name)).isNull()) << name;
    }
    EXPECT_TRUE(themedIcon(QStringLiteral("unknown")).isNull());
}

TEST_F(Icons, areInkedInTheColourOfTheirRoleOfEitherTheme) {
    const QIcon icon = themedIcon(QStringLiteral("warning"), Role::Bad);
    for (const char* name : {"light", "dark"}) {
        dress(name);
        const QImage image = icon.pixmap(24, 24).toImage();
        EXPECT_TRUE(isNear(inkOf(image), currentTheme().bad)) << name;
        const QImage disabled = icon.pixmap(QSize(24, 24), QIcon::Disabled).toImage();
        EXPECT_TRUE(isNear(inkOf(disabled), currentTheme().disabled)) << name;
    }
}

TEST_F(Icons, everyMaskDrawsSomethingInsideItsSquareAtEverySize) {
    for (const QString& name : iconNames()) {
        for (const int side : {16, 24, 32, 48}) {
            const QImage image = themedIcon(name).pixmap(side, side).toImage();
            ASSERT_EQ(image.size(), QSize(side, side));
            EXPECT_GT(inkOf(image).alpha(), 120) << name.toStdString() << side;
            for (int i = 0; i < side; ++i) {
                // A stroke that touches the rim would be cut.
                EXPECT_LT(image.pixelColor(i, 0).alpha() + image.pixelColor(i, side - 1).alpha(), 200)
                    << name.toStdString() << ' ' << side;
            }
        }
    }
}

} // namespace
} // namespace halbench::widgets
