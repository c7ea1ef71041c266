#include "widgets/language/greek_angles.h"

#include <QRegularExpression>

#include <array>
#include <utility>

namespace halbench::widgets {

QString greekAngles(QString text) {
    constexpr std::array Names = {std::pair("alpha", "α"), std::pair("beta", "β"), std::pair("gamma", "γ"),
                                  std::pair("theta", "θ"), std::pair("phi", "φ")};
    for (const auto& [name, letter] : Names) {
        // Chinese characters beside a name are no part of it.
        text.replace(QRegularExpression(
                         QStringLiteral("(?<![A-Za-z0-9_.])%1(?![A-Za-z0-9_])").arg(QLatin1String(name))),
                     QString::fromUtf8(letter));
    }
    return text;
}

} // namespace halbench::widgets
