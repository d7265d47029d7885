// The interface in C++: objects are freed by unique pointers.
#include <carom.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <vector>

template <typename T, void (*Free)(T *)>
struct Freed {
    void operator()(T *object) const { Free(object); }
};
template <typename T, void (*Free)(T *)>
using Owned = std::unique_ptr<T, Freed<T, Free>>;
using Shot = Owned<carom_shot, carom_shot_free>;
using Trace = Owned<carom_trace, carom_trace_free>;

template <typename T>
T *checked(T *made, const std::array<char, 512> &error)
{
    if (made == nullptr) {
        throw std::runtime_error(error.data());
    }
    return made;
}

int main()
{
    std::array<char, 512> error{};
    carom_break_def def{};
    def.seed = 20;
    const auto size = static_cast<std::int32_t>(error.size());
    const Shot shot{checked(carom_break_shot(&def, error.data(), size), error)};
    const Trace trace{checked(carom_shot_simulate(shot.get(), error.data(), size), error)};
    std::vector<carom_state> states(static_cast<std::size_t>(carom_shot_ball_count(shot.get())));
    const double end = carom_trace_duration(trace.get());
    if (carom_trace_states(trace.get(), end, states.data(), static_cast<int>(states.size())) != 0) {
        return 1;
    }
    for (const carom_state &state : states) {
        if (!std::isfinite(state.position[0]) || state.velocity[0] != 0.0) {
            return 1;
        }
    }
    std::printf("%016llx\n", static_cast<unsigned long long>(carom_trace_hash(trace.get())));
    return 0;
}
