#include "tests/gui/word_contrast.h"

#include "widgets/theme/theme_style.h"

#include <QFontMetrics>
#include <QHash>
#include <QImage>
#include <QPixmap>
#include <QWidget>

#include <algorithm>
#include <utility>
#include <vector>

namespace halbench::gui {
namespace {

constexpr double LargestContrast = 21.0;

/// Stretches of consecutive true values that are at most `gap` apart.
std::vector<std::pair<int, int>> stretches(const std::vector<bool>& isInk, int gap) {
    std::vector<std::pair<int, int>> found;
    for (int i = 0; i < static_cast<int>(isInk.size()); ++i) {
        if (!isInk[static_cast<std::size_t>(i)]) {
            continue;
        }
        if (found.empty() || i - found.back().second > gap) {
            found.emplace_back(i, i);
        }
        found.back().second = i;
    }
    return found;
}

QRgb commonest(const QImage& image) {
    QHash<QRgb, int> counts;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            ++counts[image.pixel(x, y)];
        }
    }
    return std::max_element(counts.begin(), counts.end()).key();
}

/// Contrast of each pixel against the background.
class Ink {
public:
    explicit Ink(const QImage& image) : m_image(image), m_ground(commonest(image)) {}

    double at(int x, int y) {
        const QRgb colour = m_image.pixel(x, y);
        auto known = m_ratios.find(colour);
        if (known == m_ratios.end()) {
            known = m_ratios.insert(colour, widgets::contrastRatio(QColor(colour), QColor(m_ground)));
        }
        return *known;
    }
    /// Of a part of the picture, by row or by column.
    std::vector<bool> lines(const QRect& part, bool isByRow) {
        std::vector<bool> isInk(static_cast<std::size_t>(isByRow ? part.height() : part.width()));
        for (int y = part.top(); y <= part.bottom(); ++y) {
            for (int x = part.left(); x <= part.right(); ++x) {
                const int line = isByRow ? y - part.top() : x - part.left();
                isInk[static_cast<std::size_t>(line)] =
                    isInk[static_cast<std::size_t>(line)] || at(x, y) > Blank;
            }
        }
        return isInk;
    }
    double strongest(const QRect& part) {
        double strongest_ratio = 1.0;
        for (int y = part.top(); y <= part.bottom(); ++y) {
            for (int x = part.left(); x <= part.right(); ++x) {
                strongest_ratio = std::max(strongest_ratio, at(x, y));
            }
        }
        return strongest_ratio;
    }

private:
    static constexpr double Blank = 1.05;

    const QImage& m_image;
    QRgb m_ground;
    QHash<QRgb, double> m_ratios;
};

} // namespace

double faintestWord_ratio(const QImage& image, int letter_px) {
    if (image.isNull()) {
        return LargestContrast;
    }
    Ink ink(image);
    double faintest_ratio = LargestContrast;
    for (const auto& [top, bottom] : stretches(ink.lines(image.rect(), true), 1)) {
        const QRect row(0, top, image.width(), bottom - top + 1);
        for (const auto& [left, right] : stretches(ink.lines(row, false), letter_px / 2)) {
            const QRect word(left, top, right - left + 1, row.height());
            if (word.width() > letter_px && word.height() >= letter_px) {
                faintest_ratio = std::min(faintest_ratio, ink.strongest(word));
            }
        }
    }
    return faintest_ratio;
}

double faintestWord_ratio(QWidget& widget, const QRect& place) {
    const QRect there(widget.mapTo(widget.window(), place.topLeft()), place.size());
    const QRect part = there.intersected(widget.window()->rect());
    if (part.isEmpty()) { // scrolled away, or a column without width
        return LargestContrast;
    }
    const QImage image = widget.window()->grab(part).toImage().convertToFormat(QImage::Format_RGB32);
    const double letter_px = widget.fontMetrics().averageCharWidth() * widget.devicePixelRatioF();
    return faintestWord_ratio(image, static_cast<int>(letter_px));
}

} // namespace halbench::gui
