// Services, their tables of handlers and hooks: which of them an access to an entry concerns.
#include <algorithm>
#include <utility>

#include "canvoy/canopen/dictionary/dictionary.hpp"

namespace canvoy {

namespace {

AbortCode put_to(const AccessHandlers& calls, void* service, const ServiceEvent& access) {
  const Entry& entry = access.entry();
  switch (access.kind) {
    case ServiceEvent::before_read:
      return calls.before_read == nullptr ? AbortCode::none : calls.before_read(service, entry);
    case ServiceEvent::before_write:
      return calls.before_write == nullptr ? AbortCode::none
                                           : calls.before_write(service, entry, access.value());
    case ServiceEvent::after_write:
      if (calls.after_write != nullptr) calls.after_write(service, entry, access.source());
      return AbortCode::none;
    default:
      return AbortCode::none;
  }
}

}  // namespace

void ObjectState::add(NodeService& service, bool in_front) {
  const auto end = services.begin() + std::min<std::size_t>(service_count, services_max);
  if (!has_all() || std::find(services.begin(), end, &service) != end) return;
  if (++service_count > services_max) return;
  if (in_front) {
    std::copy_backward(services.begin(), end, end + 1);
    services.front() = &service;
  } else {
    *end = &service;
  }
}

void ObjectState::remove(const NodeService& service) {
  if (!has_all()) return;
  const auto end = services.begin() + service_count;
  const auto found = std::find(services.begin(), end, &service);
  if (found == end) return;
  std::copy(found + 1, end, found);
  --service_count;
}

void Dictionary::tell_several_of_access(ServiceEvent& event) const {
  const std::uint16_t index = event.entry().index;
  const ObjectState& state = *event.entry().state.value;
  if (!state.has_all()) return tell_of_access_by_list(event);
  for (std::size_t i = 0; i < state.service_count && event.answer == 0; ++i) {
    NodeService* const service = state.services[i];
    if (service->covers(index)) service->notify(event);
    // What was called may have attached a hook before it.
    while (i < state.service_count && state.has_all() && state.services[i] != service) ++i;
  }
}

/// A link could be told of any object, and has hooks for a few: that is seen here, for a node has
/// many links.
void Dictionary::tell_of_access_by_list(ServiceEvent& event) const {
  const std::uint16_t index = event.entry().index;
  for (NodeService* service = services_; service != nullptr; service = service->next_) {
    if (event.answer != 0) return;
    if (!service->covers(index)) continue;
    const bool is_link = service->listener_.on_event == &HandlerBinding::on_event;
    if (is_link && !static_cast<const HandlerBinding*>(service)->covers_object(index)) continue;
    service->notify(event);
  }
}

/// The accesses of a binding are in its table; a service without a table may use all.
EntryHooks Dictionary::find_hooks(const Entry& entry) {
  EntryHooks found;
  if (is_small_machine || entry.state.value->hooks == 0) return found;
  for (NodeService* service = services_; service != nullptr; service = service->next_) {
    if (!service->covers(entry.index)) continue;
    if (service->listener_.on_event != &HandlerBinding::on_event) {
      const unsigned accesses = service->frequent_.value.accesses;
      const auto handles = [accesses](ServiceEvent::Kind access) {
        return (accesses & ServiceEvent::bit_of(access)) != 0;
      };
      add_hooks(found, {.context = this,
                        .ask = handles(ServiceEvent::before_write) ? ask_all : nullptr,
                        .notify = handles(ServiceEvent::after_write) ? notify_all : nullptr,
                        .reads = handles(ServiceEvent::before_read)});
      continue;
    }
    const HandlerBinding& link = static_cast<const HandlerBinding&>(*service);
    const auto in_table = static_cast<std::uint16_t>(entry.index - link.shift_);
    for (const AccessHandlers& calls : link.calls_->hooks) {
      if (!calls.covers(in_table, entry.sub)) continue;
      add_hooks(found, {.context = link.service_,
                        .ask = calls.before_write,
                        .notify = calls.after_write,
                        .reads = calls.before_read != nullptr});
    }
  }
  return found;
}

/// A second function of a kind, or one with another object, is called by the dictionary.
void Dictionary::add_hooks(EntryHooks& found, const EntryHooks& more) {
  found.reads |= more.reads;
  if (more.ask == nullptr && more.notify == nullptr) return;
  const bool is_first = found.ask == nullptr && found.notify == nullptr;
  const bool fits = found.context == more.context &&
                    (found.ask == nullptr || more.ask == nullptr) &&
                    (found.notify == nullptr || more.notify == nullptr);
  if (is_first || fits) {
    found.context = more.context;
    if (more.ask != nullptr) found.ask = more.ask;
    if (more.notify != nullptr) found.notify = more.notify;
    return;
  }
  found.context = this;
  if (found.ask != nullptr || more.ask != nullptr) found.ask = ask_all;
  if (found.notify != nullptr || more.notify != nullptr) found.notify = notify_all;
}

bool HandlerBinding::covers_object(std::uint16_t index) const {
  const auto in_table = static_cast<std::uint16_t>(index - shift_);
  return std::ranges::any_of(calls_->hooks,
                             [&](const AccessHandlers& calls) { return calls.covers(in_table); });
}

/// First refusal among its hooks.
AbortCode HandlerBinding::answer(const ServiceEvent& access) const {
  const Entry& entry = access.entry();
  const auto in_table = static_cast<std::uint16_t>(entry.index - shift_);
  for (const AccessHandlers& calls : calls_->hooks) {
    if (!calls.covers(in_table, entry.sub)) continue;
    const AbortCode answer = put_to(calls, service_, access);
    if (answer != AbortCode::none) return answer;
  }
  return AbortCode::none;
}

/// Calls the handler of its table for the event.
void HandlerBinding::on_event(NodeService& link, ServiceEvent& event) {
  const HandlerBinding& self = static_cast<HandlerBinding&>(link);
  const ServiceHandlers& calls = *self.calls_;
  void* const service = self.service_;
  const auto call = [service](auto function, auto... arguments) {
    if (function != nullptr) function(service, arguments...);
  };
  switch (event.kind) {
    case ServiceEvent::reset:
      return call(calls.reset, event.scope());
    case ServiceEvent::state_entered:
      return call(calls.state_entered, event.state());
    case ServiceEvent::bus_state_changed:
    case ServiceEvent::bus_recovered:
      return call(calls.bus_state_changed, event.bus_state());
    case ServiceEvent::error_came:
    case ServiceEvent::error_went:
      if (calls.error_changed == nullptr) return;
      return calls.error_changed(service, event.error(), event.kind == ServiceEvent::error_came);
    case ServiceEvent::values_changed:
      return call(calls.values_changed, event.watchers());
    case ServiceEvent::tx_ready:
      return call(calls.tx_ready);
    case ServiceEvent::before_read:
    case ServiceEvent::before_write:
    case ServiceEvent::after_write:
      return event.refuse(self.answer(event));
    default:
      return;
  }
}

void Hook::Link::on_event(NodeService& link, ServiceEvent& event) {
  const Hook& hook = *static_cast<Link&>(link).hook_;
  switch (event.kind) {
    case ServiceEvent::before_read:
      return event.refuse(hook.before_read(event.entry()));
    case ServiceEvent::before_write:
      return event.refuse(hook.before_write(event.entry(), event.value()));
    case ServiceEvent::after_write:
      return hook.after_write(event.entry(), event.source());
    case ServiceEvent::domain_wanted:
      if (hook.domain != nullptr) event.serve(*hook.domain);
      return;
    default:
      return;
  }
}

void Dictionary::attach(Hook& hook) {
  NodeService& link = hook.link;
  link.listener_.first = hook.first;
  link.listener_.last = hook.last;
  link.next_ = services_;
  if (services_ == nullptr) last_ = &link.next_;
  services_ = &link;
  if constexpr (!is_small_machine) link.frequent_.value.accesses = hook.accesses();
  mark_hooked(link, hook.first, hook.last, hook.accesses(), true);
}

/// The rows keep their marks, which are only a hint that a hook may exist; the hook itself is no
/// longer called.
void Dictionary::detach(Hook& hook) {
  NodeService** link = &services_;
  while (*link != nullptr && *link != &hook.link) link = &(*link)->next_;
  if (*link == nullptr) return;
  *link = std::exchange(hook.link.next_, nullptr);
  if (*link == nullptr) last_ = link;
  if constexpr (!is_small_machine) {
    ++revision_.value;
    for (std::size_t row = 0; row < tables_.objects.size(); ++row) {
      states_.value[row].remove(hook.link);
    }
  }
}

void Dictionary::mark_hooked(HandlerBinding& service) {
  for (const AccessHandlers& calls : service.calls_->hooks) {
    mark_hooked(service, static_cast<std::uint16_t>(calls.first + service.shift_),
                static_cast<std::uint16_t>(calls.last + service.shift_), calls.accesses());
  }
}

void Dictionary::mark_hooked(NodeService& service, std::uint16_t first, std::uint16_t last,
                             std::uint8_t accesses, bool in_front) {
  if constexpr (is_small_machine) return;
  ++revision_.value;
  for (std::size_t row = 0; row < tables_.objects.size(); ++row) {
    const ObjectRow& object = tables_.objects[row];
    if (object.index > last || object.index + object.count - 1 < first) continue;
    ObjectState& state = states_.value[row];
    state.hooks |= accesses;
    state.add(service, in_front);
  }
}

}  // namespace canvoy
