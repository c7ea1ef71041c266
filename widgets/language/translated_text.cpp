#include "widgets/language/translated_text.h"

#include <QEvent>
#include <QWidget>

#include <utility>

namespace halbench::widgets {

namespace {

/// A widget hands a change of language on to its children.
class Speaker : public QObject {
public:
    Speaker(QWidget& widget, std::function<void()> say) : QObject(&widget), m_say(std::move(say)) { m_say(); }

    bool event(QEvent* event) override {
        if (event->type() == QEvent::LanguageChange) {
            m_say();
        }
        return QObject::event(event);
    }

private:
    std::function<void()> m_say;
};

} // namespace

void sayWords(QWidget& widget, std::function<void()> say) {
    new Speaker(widget, std::move(say));
}

} // namespace halbench::widgets
