// The small node without SDO block transfers.
#include "bench/size/small_node.hpp"

using Node = canvoy::SmallNode<false>;

constinit static Node::Device::Memory the_memory{};
constinit static Node the_node(the_memory);

int main() {
  the_node.run();
}
