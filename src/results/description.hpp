// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// The one description of each part of a result: what is written, what may be read, and the schema
// follow from it. A described struct T has a function `Description<T> describe(const T*)`.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "files/json_value.hpp"
#include "results/result_rule.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/results/results_json.hpp"
#include "taut/survey/forces.hpp"

namespace taut {

/// What a part is written from besides itself.
struct Context {
    const CableNet* net = nullptr;
    const RunRecord* run = nullptr;
    const Survey* survey = nullptr;         ///< of an identification
    const Identification* found = nullptr;  ///< likewise
};

/// A value of an object `it` in its context `c`.
#define TAUT_VALUE(...) \
    []([[maybe_unused]] const auto& it, [[maybe_unused]] const Context& c) { return __VA_ARGS__; }

/// The value, or none.
template <class V>
std::optional<std::decay_t<V>> when(bool is_there, const V& value) {
    return is_there ? std::optional<std::decay_t<V>>(value) : std::nullopt;
}

template <class T>
class Description;

/// Whether a described struct is read again; the others need no readers, which take time to
/// compile.
template <class T>
inline constexpr bool is_read = false;

/// Made once.
template <class T>
const Description<T>& description_of() {
    static const Description<T> description = describe(static_cast<const T*>(nullptr));
    return description;
}

// Enums that are read, or whose words are in the schema: the last of each.
constexpr Trust::Verdict last_of(Trust::Verdict /*type*/) {
    return Trust::Verdict::failed;
}
constexpr Trust::Finding::Kind last_of(Trust::Finding::Kind /*type*/) {
    return Trust::Finding::Kind::other;
}
constexpr ForceSource last_of(ForceSource /*type*/) {
    return ForceSource::sag;
}
constexpr EdgeStatus last_of(EdgeStatus /*type*/) {
    return EdgeStatus::slack;
}

template <class E>
std::vector<E> enumerators() {
    std::vector<E> all;
    for (int i = 0; i <= static_cast<int>(last_of(E())); ++i) {
        all.push_back(static_cast<E>(i));
    }
    return all;
}

template <class E>
std::vector<std::string> words_of_enum() {
    std::vector<std::string> words;
    for (const E value : enumerators<E>()) {
        words.emplace_back(to_string(value));
    }
    return words;
}

/// The type of the values inside lists and optionals.
template <class V>
struct Inside {
    using Type = V;
    static constexpr bool is_list = false, is_optional = false;
};
template <class V>
struct Inside<std::vector<V>> {
    using Type = V;
    static constexpr bool is_list = true, is_optional = false;
};
template <class V>
struct Inside<std::optional<V>> {
    using Type = V;
    static constexpr bool is_list = false, is_optional = true;
};

template <class V>
constexpr bool is_text = std::is_convertible_v<V, std::string_view>;
template <class V>
constexpr bool is_in_words =
    std::is_same_v<V, LengthPrior> || std::is_same_v<V, UncertainParameter>;

/// The rule that follows from a type.
template <class V>
Rule rule_of() {
    if constexpr (Inside<V>::is_list) {
        return Rule::list_of(rule_of<typename Inside<V>::Type>());
    } else if constexpr (Inside<V>::is_optional) {
        return rule_of<typename Inside<V>::Type>();  // whether null is allowed depends on the field
    } else if constexpr (std::is_same_v<V, bool>) {
        return Rule::flag();
    } else if constexpr (std::is_same_v<V, std::uint64_t>) {
        return whole;
    } else if constexpr (std::is_integral_v<V>) {
        return Rule::count();
    } else if constexpr (std::is_floating_point_v<V>) {
        return Rule::number();
    } else if constexpr (std::is_enum_v<V>) {
        return Rule::one_of(words_of_enum<V>());
    } else if constexpr (is_text<V> || is_in_words<V>) {
        return Rule::text();
    } else if constexpr (std::is_same_v<V, Eigen::Vector3d>) {
        return Rule::point();
    } else if constexpr (std::is_same_v<V, std::array<int, 2>>) {
        return Rule::list_of(Rule::count(), 2);
    } else {
        return description_of<V>().rule();
    }
}

/// A value as JSON.
template <class V>
ResultJson json_of(const V& value, const Context& context) {
    if constexpr (Inside<V>::is_list) {
        ResultJson list = ResultJson::array();
        for (const auto& entry : value) {
            list.push_back(json_of<typename Inside<V>::Type>(entry, context));
        }
        return list;
    } else if constexpr (Inside<V>::is_optional) {
        return value ? json_of(*value, context) : ResultJson();
    } else if constexpr (std::is_enum_v<V> || is_in_words<V>) {
        return to_string(value);
    } else if constexpr (std::is_same_v<V, Eigen::Vector3d>) {
        return {value.x(), value.y(), value.z()};
    } else if constexpr (std::is_arithmetic_v<V> || is_text<V> || std::is_same_v<V, ResultJson> ||
                         std::is_same_v<V, std::array<int, 2>>) {
        return value;
    } else {
        return description_of<V>().write(value, context);
    }
}

inline void read_value(const JsonValue& json, double& value) {
    value = json.number();
}
inline void read_value(const JsonValue& json, int& value) {
    value = json.integer();
}
inline void read_value(const JsonValue& json, bool& value) {
    value = json.flag();
}
inline void read_value(const JsonValue& json, std::string& value) {
    value = json.text();
}
inline void read_value(const JsonValue& json, Eigen::Vector3d& value) {
    value = {json.at(0).number(), json.at(1).number(), json.at(2).number()};
}
/// @throws InputError for what parse_uncertain_parameter() refuses
void read_value(const JsonValue& json, UncertainParameter& value);
/// Knows the words of 0.2.0, too.
void read_value(const JsonValue& json, EdgeStatus& value);
void read_value(const JsonValue& json, ForceSource& value);

/// Reads a value that the schema accepts.
template <class V>
void read_value(const JsonValue& json, V& value) {
    if constexpr (Inside<V>::is_list) {
        for (size_t i = 0; i < json.json().size(); ++i) {
            read_value(json.at(i), value.emplace_back());
        }
    } else if constexpr (Inside<V>::is_optional) {
        if (!json.json().is_null()) {
            read_value(json, value.emplace());
        }
    } else if constexpr (std::is_enum_v<V>) {
        for (const V one : enumerators<V>()) {
            value = json.text() == to_string(one) ? one : value;
        }
    } else {
        description_of<V>().read(json, value);
    }
}

template <class V>
V read(const JsonValue& json) {
    V value{};
    read_value(json, value);
    return value;
}

/// A value that may be missing or null; then as it is by default.
template <class V>
V read_or_default(const JsonValue& parent, const std::string& key) {
    const auto found = parent.find(key);
    return found && !found->json().is_null() ? read<V>(*found) : V{};
}

/// The JSON object of a struct, field by field.
///
/// A field is a member pointer, a function that refers to a place in the object, or one that gives
/// a value, of the object alone or with its context. The first two can be read. An empty optional
/// is null.
template <class T>
class Description {
public:
    /// @param name of its definition in the schema; empty: it stands where it is used
    explicit Description(std::string name = "", std::string text = "")
        : m_rule(std::move(name), std::move(text)) {}

    /// A key that each result has.
    /// @param about the rule where it does not follow from the type, then what it is, with its unit
    template <class Get, class... About>
    Description& key(const char* name, const Get& get, const About&... about) {
        return add<std::decay_t<Get>>(name, get, rule_for<std::decay_t<Get>>(true, about...),
                                      Presence::always);
    }
    /// A key that results of older versions lack.
    template <class Get, class... About>
    Description& newer(const char* name, const Get& get, const About&... about) {
        return add<std::decay_t<Get>>(name, get, rule_for<std::decay_t<Get>>(true, about...),
                                      Presence::newer);
    }
    /// A key that is left out where it would be null.
    template <class Get, class... About>
    Description& optional(const char* name, const Get& get, const About&... about) {
        return add<std::decay_t<Get>>(name, get, rule_for<std::decay_t<Get>>(false, about...),
                                      Presence::where_known);
    }
    /// An object inside this one that has no struct of its own.
    Description& object(const char* key, const Description& inner, const char* text = "") {
        return group(key, inner, text, Presence::always);
    }
    Description& newer_object(const char* key, const Description& inner, const char* text = "") {
        return group(key, inner, text, Presence::newer);
    }

    [[nodiscard]] ResultJson write(const T& value, const Context& context) const {
        ResultJson object = ResultJson::object();
        for (const Field& field : m_fields) {
            ResultJson member = field.write(value, context);
            if (field.presence != Presence::where_known || !member.is_null()) {
                object[field.key] = std::move(member);
            }
        }
        return object;
    }
    void read(const JsonValue& json, T& value) const {
        static_assert(is_read<T>, "say that it is read, beside its describe()");
        for (const Field& field : m_fields) {
            const auto member = field.read ? json.find(field.key) : std::nullopt;
            if (member) {
                field.read(*member, value);
            }
        }
    }
    [[nodiscard]] Rule rule() const { return m_rule.rule(); }

private:
    enum class Presence { always, newer, where_known };
    struct Field {
        std::string key;
        Presence presence;
        std::function<ResultJson(const T&, const Context&)> write;
        std::function<void(const JsonValue&, T&)> read;  ///< empty: it is only written
    };

    template <class Get>
    static decltype(auto) value_of(const Get& get, const T& object, const Context& context) {
        if constexpr (std::is_invocable_v<Get, const T&, const Context&>) {
            return get(object, context);
        } else {
            return std::invoke(get, object);
        }
    }
    template <class Get>
    using Value = std::remove_cvref_t<decltype(value_of(
        std::declval<Get>(), std::declval<const T&>(), std::declval<const Context&>()))>;

    template <class Get>
    static Rule rule_for(bool or_null, const Rule& rule, const char* text = "") {
        return (or_null && Inside<Value<Get>>::is_optional ? rule.or_null() : rule).with_text(text);
    }
    template <class Get>
    static Rule rule_for(bool or_null, const char* text = "") {
        return rule_for<Get>(or_null, rule_of<Value<Get>>(), text);
    }

    template <class Get>
    Description& add(const char* name, const Get& get, const Rule& rule, Presence presence) {
        Field field{.key = name,
                    .presence = presence,
                    .write =
                        [get](const T& object, const Context& context) {
                            return json_of<Value<Get>>(value_of(get, object, context), context);
                        },
                    .read = {}};
        if constexpr (is_read<T> && std::is_invocable_v<Get, T&>) {
            using Place = std::invoke_result_t<Get, T&>;
            if constexpr (std::is_lvalue_reference_v<Place> &&
                          !std::is_const_v<std::remove_reference_t<Place>>) {
                field.read = [get](const JsonValue& json, T& object) {
                    read_value(json, std::invoke(get, object));
                };
            }
        }
        m_fields.push_back(std::move(field));
        m_rule.add(name, rule, presence == Presence::always);
        return *this;
    }
    Description& group(const char* key, const Description& inner, const char* text,
                       Presence presence) {
        const Rule rule = inner.rule().with_text(text);
        m_fields.push_back(
            {.key = key,
             .presence = presence,
             .write = [inner](const T& object,
                              const Context& context) { return inner.write(object, context); },
             .read = {}});
        m_rule.add(key, rule, presence == Presence::always);
        return *this;
    }

    ObjectRule m_rule;
    std::vector<Field> m_fields;
};

}  // namespace taut
