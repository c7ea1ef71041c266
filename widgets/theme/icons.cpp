#include "widgets/theme/icons.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPixmap>
#include <QPixmapCache>
#include <QSvgRenderer>

#include <optional>
#include <utility>

// The macro declares a function of the global namespace.
static void registerIcons() {
    Q_INIT_RESOURCE(icons);
}

namespace halbench::widgets {
namespace {

constexpr double StrokeWidth_px = 1.5;
constexpr double Grid_px = 24.0;

class MaskEngine : public QIconEngine {
public:
    MaskEngine(QString name, QByteArray mask, Role role, const std::optional<QColor>& colour)
        : m_name(std::move(name)), m_mask(std::move(mask)), m_role(role), m_colour(colour) {}

    void paint(QPainter* painter, const QRect& box, QIcon::Mode mode, QIcon::State) override {
        draw(*painter, box, 1.0, mode);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State) override {
        return drawn(size, 1.0, mode);
    }

    void virtual_hook(int id, void* data) override {
        if (id == QIconEngine::ScaledPixmapHook) {
            auto* argument = static_cast<QIconEngine::ScaledPixmapArgument*>(data);
            argument->pixmap = drawn(argument->size, argument->scale, argument->mode);
            return;
        }
        QIconEngine::virtual_hook(id, data);
    }

    QIconEngine* clone() const override { return new MaskEngine(m_name, m_mask, m_role, m_colour); }

private:
    QColor colour(QIcon::Mode mode) const {
        const Theme theme = currentTheme();
        return mode == QIcon::Disabled ? theme.disabled : m_colour.value_or(roleColour(theme, m_role));
    }

    /// `scale`: device pixels per logical pixel; lines are 1.5 logical pixels at every size.
    void draw(QPainter& painter, const QRect& box, double scale, QIcon::Mode mode) const {
        const double side = qMin(box.width(), box.height());
        const double width = StrokeWidth_px * scale * Grid_px / qMax(side, 1.0);
        QByteArray svg = m_mask;
        svg.replace("currentColor", colour(mode).name().toLatin1());
        svg.replace("stroke-width=\"1.5\"", "stroke-width=\"" + QByteArray::number(width) + '"');
        QSvgRenderer renderer(svg);
        renderer.render(&painter, QRectF(box.x() + (box.width() - side) / 2.0,
                                         box.y() + (box.height() - side) / 2.0, side, side));
    }

    QPixmap drawn(const QSize& size, double scale, QIcon::Mode mode) const {
        const QString key = QStringLiteral("halbench/%1/%2/%3x%4/%5")
                                .arg(m_name, colour(mode).name())
                                .arg(size.width())
                                .arg(size.height())
                                .arg(scale);
        QPixmap pixmap;
        if (!QPixmapCache::find(key, &pixmap)) {
            pixmap = QPixmap(size);
            pixmap.fill(Qt::transparent);
            QPainter painter(&pixmap);
            draw(painter, QRect(QPoint(0, 0), size), scale, mode);
            painter.end();
            QPixmapCache::insert(key, pixmap);
        }
        return pixmap;
    }

    QString m_name;
    QByteArray m_mask;
    Role m_role;
    std::optional<QColor> m_colour;
};

QIcon iconOf(const QString& name, Role role, const std::optional<QColor>& colour) {
    registerIcons();
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    return QIcon(new MaskEngine(name, file.readAll(), role, colour));
}

} // namespace

QIcon themedIcon(const QString& name, Role role) {
    return iconOf(name, role, std::nullopt);
}

QIcon colouredIcon(const QString& name, const QColor& colour) {
    return iconOf(name, Role::None, colour);
}

QStringList iconNames() {
    registerIcons();
    QStringList names;
    for (const QString& file : QDir(QStringLiteral(":/icons")).entryList()) {
        names << file.section(QLatin1Char('.'), 0, 0);
    }
    return names;
}

} // namespace halbench::widgets
