#include "labs/01_recursive/threads.h"

#include <pthread.h>

#include <system_error>
#include <vector>

namespace raylab::lab01 {

// std::thread cannot choose its stack: a path of 10,000 surfaces needs more than the usual 8 MB.
void run_on_threads(int count, std::size_t stack_bytes, const std::function<void()>& work) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    int error = pthread_attr_setstacksize(&attributes, stack_bytes);
    std::vector<pthread_t> threads;
    const auto entry = [](void* argument) -> void* {
        (*static_cast<const std::function<void()>*>(argument))();
        return nullptr;
    };
    while (error == 0 && static_cast<int>(threads.size()) < count) {
        pthread_t thread;
        error = pthread_create(&thread, &attributes, entry,
                               const_cast<void*>(static_cast<const void*>(&work)));
        if (error == 0) threads.push_back(thread);
    }
    for (const pthread_t thread : threads) pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    if (error != 0)
        throw std::system_error(error, std::generic_category(), "starting a render thread");
}

} // namespace raylab::lab01
