// The small node with static PDO mapping, without SDO block transfers.
#include "bench/size/static_pdos.hpp"

using Node = canvoy::SmallNode<canvoy::node_tables>;

constinit static Node::Device::Memory the_memory{};
constinit static Node the_node(the_memory);

int main() {
  the_node.run();
}
