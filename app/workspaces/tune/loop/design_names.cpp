#include "app/workspaces/tune/loop/design_names.h"

#include <QCoreApplication>

namespace halbench::app {

namespace {

constexpr char Context[] = "halbench::app::DesignNames";

struct Title {
    const char* name;
    const char* words;
};

constexpr Title Titles[] = {
    {"recommended", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "recommended")},
    {"pole-placement", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "pole placement")},
    {"bandwidth", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "bandwidth")},
    {"phase-margin", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "phase margin")},
    {"simc", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "SIMC")},
    {"lambda", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "lambda")},
    {"ziegler-nichols", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "Ziegler-Nichols PID")},
    {"ziegler-nichols-pi", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "Ziegler-Nichols PI")},
    {"ziegler-nichols-p", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "Ziegler-Nichols P")},
    {"lqr", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "LQR")},
    {"min-iae", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "least IAE")},
    {"min-itae", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "least ITAE")},
    {"lead", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "lead")},
    {"lag", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "lag")},
    {"published", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "published")},
    {"designed", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "designed")},
    {"micro-step", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "micro-step")},
    {"published-degrees", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "published, in degrees")},
    {"published-in-degrees", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "published, in degrees")},
    {"device", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "from the device")},
    {"edited", QT_TRANSLATE_NOOP("halbench::app::DesignNames", "edited manually")}};

} // namespace

QString designTitle(const std::string& name) {
    for (const Title& title : Titles) {
        if (name == title.name) {
            return QCoreApplication::translate(Context, title.words);
        }
    }
    return QString::fromStdString(name);
}

} // namespace halbench::app
